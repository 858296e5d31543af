#include "tools/listen/ros_messages.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/math/types.hpp"
#include "tools/listen/covariance.hpp"

namespace articam::listen {
namespace {

void put_header(CdrWriter& out, const Heard& heard, const std::string& frame_id) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  std::int64_t sec = heard.times.t_capture_wall_ns / kSecond_ns;
  std::int64_t nanosec = heard.times.t_capture_wall_ns % kSecond_ns;
  if (nanosec < 0) --sec, nanosec += kSecond_ns;
  out << static_cast<std::int32_t>(sec) << static_cast<std::uint32_t>(nanosec) << frame_id;
}

template <std::size_t N>
std::vector<double> to_vector(const FixedVector<double, N>& list) {
  return {list.begin(), list.end()};
}

std::vector<std::string> joint_names(const wire::ModelMessage& model) {
  std::vector<std::string> names;
  for (const wire::Text& name : model.joint_names) names.emplace_back(wire::view(name));
  return names;
}

/// ROS writes quaternions x y z w.
void put_pose(CdrWriter& out, const wire::PoseNumbers& T) {
  for (const std::size_t i : {0u, 1u, 2u, 4u, 5u, 6u, 3u}) out << T[i];
}

Mat<double, 3, 3> rotation(const wire::PoseNumbers& T) {
  return Quat<double>{T[3], T[4], T[5], T[6]}.normalized().toRotationMatrix();
}

/// Covariance of translation and rotation, both turned from {cam} by R, row by row.
std::array<double, 36> turned_covariance(const wire::EstimateMessage& estimate, const Mat<double, 3, 3>& R) {
  Mat<double, 6, 6> C, turn = Mat<double, 6, 6>::Zero();
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < 6; ++k) {
      C(i, k) = covariance(estimate, static_cast<std::size_t>(i), static_cast<std::size_t>(k));
    }
  }
  turn.topLeftCorner<3, 3>() = R;
  turn.bottomRightCorner<3, 3>() = R;
  const Mat<double, 6, 6> turned = turn * C * turn.transpose();
  std::array<double, 36> rows{};
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < 6; ++k) rows[static_cast<std::size_t>(6 * i + k)] = turned(i, k);
  }
  return rows;
}

}  // namespace

void put_joint_state(CdrWriter& out, const Heard& heard) {
  const std::vector<double> rates = to_vector(heard.estimate.velocity);
  put_header(out, heard, "");
  out << joint_names(heard.model) << to_vector(heard.estimate.joints)
      << std::vector<double>(rates.begin() + 6, rates.end()) << std::vector<double>{};
}

void put_pose_in_camera(CdrWriter& out, const Heard& heard) {
  put_header(out, heard, "camera");
  put_pose(out, heard.estimate.t_cam_obj);
  out << turned_covariance(heard.estimate, Mat<double, 3, 3>::Identity());
}

void put_pose_in_base(CdrWriter& out, const Heard& heard) {
  const Mat<double, 3, 3> R_base_cam =
      rotation(heard.estimate.t_base_obj) * rotation(heard.estimate.t_cam_obj).transpose();
  put_header(out, heard, "base");
  put_pose(out, heard.estimate.t_base_obj);
  out << turned_covariance(heard.estimate, R_base_cam);
}

void put_estimate(CdrWriter& out, const Heard& heard) {
  const wire::EstimateMessage& e = heard.estimate;
  std::vector<std::uint8_t> observability;
  for (const tracker::Observability x : e.observability) observability.push_back(static_cast<std::uint8_t>(x));
  put_header(out, heard, "camera");
  out << e.session << e.model_hash << std::string{wire::view(heard.model.name)} << e.number << e.frame << e.t_capture.ns
      << e.t_send.ns << heard.times.age_s << heard.times.age_is_exact << static_cast<std::uint8_t>(e.status)
      << static_cast<std::uint8_t>(e.reason) << std::string{name(e.status)} << std::string{name(e.reason)} << e.valid
      << to_vector(e.t_cam_obj) << joint_names(heard.model) << to_vector(e.joints) << to_vector(e.velocity)
      << to_vector(e.covariance) << observability << e.matched << e.rms_px << to_vector(e.t_base_obj);
}

}  // namespace articam::listen
