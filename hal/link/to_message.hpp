#pragma once
/// @file  The tracker's estimate as the message that goes to the controller.

#include <algorithm>
#include <string_view>

#include "core/camera_parameters.hpp"
#include "core/model/table_hash.hpp"
#include "core/tracker/estimate.hpp"
#include "hal/wire/message.hpp"

namespace articam::hal {

namespace detail {

template <class List, class T>
void put(List& list, T x) noexcept {
  static_cast<void>(list.push_back(x));  // the static_assert below has seen to the room
}

inline void put_pose(wire::PoseNumbers& out, const Pose<double>& T) noexcept {
  for (const double x : {T.t.x(), T.t.y(), T.t.z(), T.R.w(), T.R.x(), T.R.y(), T.R.z()}) put(out, x);
}

/// As much as there is room for, cut between two characters: protobuf refuses half of one.
inline void put_text(wire::Text& out, std::string_view text) noexcept {
  std::size_t size = std::min(text.size(), wire::kMaxName);
  const auto continues = [&] { return size < text.size() && (static_cast<unsigned char>(text[size]) & 0xc0) == 0x80; };
  while (size > 0 && continues()) --size;
  for (const char c : text.substr(0, size)) put(out, c);
}

}  // namespace detail

/// Turns estimates of one model into messages of one session.
template <class Model>
class ToMessage {
 public:
  static_assert(model::kNumJoints<Model> <= static_cast<int>(wire::kMaxJoints),
                "the link has room for 16 joints: freeze some when compiling the model, or widen articam.options");

  ToMessage(const CameraParameters& camera, std::uint64_t session, double rate_hz) noexcept
      : session_{session}, rate_hz_{rate_hz}, has_base_{camera.has_t_base_cam} {
    const auto& [x, y, z] = camera.t_base_cam_m;
    const auto& [qw, qx, qy, qz] = camera.r_base_cam_wxyz;
    T_base_cam_ = {Quat<double>{qw, qx, qy, qz}.normalized(), {x, y, z}};
  }

  /// Everything but the number and the time of sending. Numbers of an estimate that is not valid stay out: what is not
  /// sent is not mistaken for an estimate.
  template <class S>
  wire::EstimateMessage estimate(const tracker::Estimate<Model, S>& e) const noexcept {
    wire::EstimateMessage m;
    m.session = session_, m.model_hash = kHash;
    m.frame = e.frame, m.t_capture = e.t_capture;
    m.status = e.status, m.reason = e.reason, m.valid = e.valid;
    for (const tracker::Observability x : e.observability) detail::put(m.observability, x);
    m.matched = static_cast<std::uint32_t>(e.matched);
    m.rms_px = e.matched > 0 ? static_cast<double>(e.rms_px) : 0;
    if (!e.valid) return m;
    const Pose<double> T_cam_obj{e.q.T_cam_obj.R.template cast<double>(), e.q.T_cam_obj.t.template cast<double>()};
    detail::put_pose(m.t_cam_obj, T_cam_obj);
    for (int j = 0; j < model::kNumJoints<Model>; ++j) detail::put(m.joints, static_cast<double>(e.q.joints[j]));
    for (int i = 0; i < model::kDof<Model>; ++i) {
      detail::put(m.velocity, static_cast<double>(e.qdot[i]));
      for (int k = i; k < model::kDof<Model>; ++k) detail::put(m.covariance, static_cast<double>(e.covariance(i, k)));
    }
    if (has_base_) detail::put_pose(m.t_base_obj, T_base_cam_ * T_cam_obj);
    return m;
  }

  /// Names longer than 63 bytes are cut short.
  wire::ModelMessage model() const noexcept {
    wire::ModelMessage m;
    m.session = session_, m.model_hash = kHash;
    detail::put_text(m.name, Model::kName);
    for (const model::JointRow& joint : model::kValueRows<Model>) {
      wire::Text text;
      detail::put_text(text, joint.name);
      detail::put(m.joint_names, text);
      detail::put(m.joint_kinds, joint.kind);
    }
    m.rate_hz = rate_hz_;
    if (has_base_) detail::put_pose(m.t_base_cam, T_base_cam_);
    return m;
  }

 private:
  static constexpr std::uint64_t kHash = model::table_hash<Model>();

  std::uint64_t session_;
  double rate_hz_;
  bool has_base_;
  Pose<double> T_base_cam_;
};

}  // namespace articam::hal
