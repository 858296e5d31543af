#pragma once
/// @file  The messages of articam.proto as plain values of fixed capacity, the same at both ends of the link.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/fixed_vector.hpp"
#include "core/model/model_table.hpp"
#include "core/timestamp.hpp"
#include "core/tracker/tracking_status.hpp"

namespace articam::wire {

inline constexpr std::uint32_t kSchema = 2;  ///< of articam.proto

// The capacities of articam.options.
inline constexpr std::size_t kMaxJoints = 16;
inline constexpr std::size_t kMaxDof = 6 + kMaxJoints;
inline constexpr std::size_t kMaxName = 63;

/// Numbers of the upper triangle, by rows, of a symmetric matrix.
constexpr std::size_t triangle_size(std::size_t dof) noexcept { return dof * (dof + 1) / 2; }

/// A pose T_a_b, x y z qw qx qy qz in m; empty where it is not known.
using PoseNumbers = FixedVector<double, 7>;
using Text = FixedVector<char, kMaxName>;

inline std::string_view view(const Text& text) noexcept { return {text.begin(), text.size()}; }

/// What the board says at every turn of its loop. Only if `valid` are there a pose, joints, velocity and covariance.
/// Units   m, rad, s.
/// Frames  velocity and covariance of (t, rotation) are written in {cam}, the rotation as R = exp(delta) R_est.
struct EstimateMessage {
  std::uint32_t schema{kSchema};
  std::uint64_t session{};     ///< drawn at each start of the board's program
  std::uint64_t model_hash{};  ///< articam::model::table_hash
  std::uint32_t number{};      ///< of the message in its session; a gap is a lost one
  std::uint32_t frame{};
  Timestamp t_capture{};  ///< mid-exposure, on the board's clock
  Timestamp t_send{};     ///< on the board's clock
  tracker::TrackingStatus status{};
  tracker::Reason reason{};
  bool valid{};
  PoseNumbers t_cam_obj{};
  FixedVector<double, kMaxJoints> joints{};
  FixedVector<double, kMaxDof> velocity{};  ///< rates of t, rotation and joints
  FixedVector<double, triangle_size(kMaxDof)> covariance{};
  FixedVector<tracker::Observability, kMaxDof> observability{};
  std::uint32_t matched{};
  double rms_px{};
  PoseNumbers t_base_obj{};
};

/// What the numbers of an EstimateMessage are called. Sent once a second.
struct ModelMessage {
  std::uint32_t schema{kSchema};
  std::uint64_t session{};
  std::uint64_t model_hash{};
  Text name{};
  FixedVector<Text, kMaxJoints> joint_names{};
  double rate_hz{};  ///< nominal
  PoseNumbers t_base_cam{};
  FixedVector<model::JointKind, kMaxJoints> joint_kinds{};  ///< as many as names; empty where the board does not tell
};

/// Of the values of a joint: rad or m; empty where the board does not tell.
constexpr std::string_view unit(const ModelMessage& model, std::size_t joint) noexcept {
  if (joint >= model.joint_kinds.size()) return "";
  return model.joint_kinds[joint] == model::JointKind::prismatic ? "m" : "rad";
}

enum class MessageKind : std::uint8_t { none, estimate, model };

/// The content of one packet: the part that `kind` names, the other one as it was before.
struct Message {
  MessageKind kind{MessageKind::none};
  EstimateMessage estimate{};
  ModelMessage model{};
};

}  // namespace articam::wire
