#pragma once
/// @file  Where in a ring its hole is seen: perspective parts the centres of two circles that have one.

#include <cstdint>

#include "core/camera_parameters.hpp"
#include "core/vision/detection.hpp"

namespace articam::vision {

inline constexpr std::int32_t kMinFocal_q16 = 16 << 16;  // px; keeps the integers below in their range

/// A camera as far as that needs it.
struct Pinhole {
  std::int32_t focal_q16{};       ///< px, from kMinFocal_q16 on; 0: not known
  std::int32_t u_q16{}, v_q16{};  ///< principal point, px
  std::int32_t unsure_q16{};      ///< standard deviation of an offset, as a share of HoleOffset::scale_q16, 0 to 1

  constexpr bool known() const noexcept { return focal_q16 != 0; }
  constexpr bool ok() const noexcept {
    return !known() || (focal_q16 >= kMinFocal_q16 && unsure_q16 >= 0 && unsure_q16 <= 1 << 16);
  }
};

/// Of a calibrated camera; not known where its focal length is below kMinFocal_q16. The offset is of second order in
/// size by distance, and so is what a lens that distorts adds to it, which is not known here.
Pinhole pinhole_of(const CameraParameters& camera) noexcept;

/// Of a camera of which only the frame's size is known: about 64 degrees across, as most are.
Pinhole likely_pinhole(int width_px, int height_px) noexcept;

/// Centre of the hole's image less that of the ring's, px: mean + half, or mean - half. The two circles that are seen
/// as one ellipse (circle_poses.hpp) have one each.
struct HoleOffset {
  std::int32_t mean_u_q16{}, mean_v_q16{};
  std::int32_t half_u_q16{}, half_v_q16{};
  std::int32_t scale_q16{};  ///< of a hole in a ring tilted by 45 degrees it would be half of this, px
  std::int32_t major_q16{};  ///< semi-axis of the ring were it turned to the camera, in the middle of the frame, px
};

/// With X the ellipse's centre on the metric plane Z = 1, S = M M^T / f^2 its shape, n the circle's normal and k the
/// hole's share of its radius, the dual conic  c c^T - r^2 (I - n n^T)  gives to first order in S
///
///     S = rho^2 (I + X X^T - m m^T),    m = n_xy - n_z X,    rho = r / z
///     centre of the hole - of the ring = -(1 - k^2) rho^2 (X + n_z m)
///
/// rho^2 is the larger root of det(S - rho^2 (I + X X^T)) = 0. m is known but for its sign; with T = 1 + X.X the two
/// solutions have  X + n_z m = X - m (m.X) / T  -+  m sqrt(T (1 - m.m) + (m.X)^2) / T.
/// Errors  false where the ellipse's centre is more than 75 degrees off the camera's axis.
bool hole_offset(const Ellipse& ring, const Pinhole& camera, std::int32_t ratio_q16, HoleOffset& out) noexcept;

}  // namespace articam::vision
