#include <algorithm>
#include <cstddef>

#include "hal/wire/message_reader.hpp"

namespace articam::wire {
namespace {

/// x - x is 0 only for a number that is finite.
constexpr bool is_finite(double x) noexcept { return x - x == 0; }

template <std::size_t N>
bool all_finite(const FixedVector<double, N>& list) noexcept {
  return std::ranges::all_of(list, is_finite);
}

bool is_pose(const PoseNumbers& pose) noexcept {
  if (pose.size() != 7 || !all_finite(pose)) return false;
  double norm2 = 0;
  for (std::size_t i = 3; i < 7; ++i) norm2 += pose[i] * pose[i];
  return norm2 > 0.999 && norm2 < 1.001;  // a board that computes in float misses 1 by 1e-6
}

/// Of the upper triangle, by rows, of a matrix of that size.
bool has_variances(const decltype(EstimateMessage::covariance)& triangle, std::size_t dof) noexcept {
  std::size_t diagonal = 0;
  for (std::size_t i = 0; i < dof; diagonal += dof - i, ++i) {
    if (triangle[diagonal] < 0) return false;
  }
  return true;
}

bool is_name(const Text& text) noexcept {
  return !text.empty() && std::ranges::none_of(text, [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == ',' || c == '"';
  });
}

bool has_no_numbers(const EstimateMessage& m) noexcept {
  return m.t_cam_obj.empty() && m.joints.empty() && m.velocity.empty() && m.covariance.empty() && m.t_base_obj.empty();
}

bool has_all_numbers(const EstimateMessage& m) noexcept {
  const std::size_t dof = 6 + m.joints.size();
  return is_pose(m.t_cam_obj) && (m.t_base_obj.empty() || is_pose(m.t_base_obj)) && m.velocity.size() == dof &&
         m.covariance.size() == triangle_size(dof) && m.observability.size() == dof && all_finite(m.joints) &&
         all_finite(m.velocity) && all_finite(m.covariance) && has_variances(m.covariance, dof);
}

}  // namespace

Fault check(const EstimateMessage& m) noexcept {
  if (!is_finite(m.rms_px) || m.rms_px < 0) return Fault::inconsistent;
  if (!m.valid) return has_no_numbers(m) ? Fault::none : Fault::inconsistent;
  return has_all_numbers(m) && m.t_capture <= m.t_send ? Fault::none : Fault::inconsistent;
}

Fault check(const ModelMessage& m) noexcept {
  const bool named = is_name(m.name) && std::ranges::all_of(m.joint_names, is_name);
  const bool fits = m.joint_kinds.empty() || m.joint_kinds.size() == m.joint_names.size();
  const bool sound = is_finite(m.rate_hz) && m.rate_hz >= 0 && (m.t_base_cam.empty() || is_pose(m.t_base_cam));
  return named && fits && sound ? Fault::none : Fault::inconsistent;
}

}  // namespace articam::wire
