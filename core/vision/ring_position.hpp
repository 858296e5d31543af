#pragma once
/// @file  Where a circular mark is, from its image alone: the simple form that equation (7) needs.

#include <cmath>

#include "core/status.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/detection.hpp"

namespace articam::vision {

/// Position of the mark's centre in {cam}, m. The major axis of the image is hardly shortened by tilt, so
/// Z = radius / semi-major axis on the metric plane; the centre of the ellipse gives the direction.
/// Bias  of second order in (radius / Z) and tilt; blur shortens the axis and lengthens Z.
/// Errors  bad_argument for an empty ellipse or radius; outside_domain from the lens model.
template <class S>
Result<Vec<S, 3>> ring_position(const Ellipse& image, S radius_m, const CameraModel<S>& camera) noexcept {
  const auto s = camera.unproject({S(from_q16(image.u_q16)), S(from_q16(image.v_q16))});
  if (!s.ok()) return s.status();
  const S a = S(from_q16(image.m00_q16)) / S(camera.parameters().fx_px);
  const S b = S(from_q16(image.m10_q16)) / S(camera.parameters().fy_px);
  const S d = S(from_q16(image.m11_q16)) / S(camera.parameters().fy_px);
  // Largest eigenvalue of M M^T, M = | a 0 ; b d |: the squared semi-major axis.
  const S half_trace = S(0.5) * (a * a + b * b + d * d);
  const S det = a * a * d * d;
  const S gap2 = half_trace * half_trace - det;
  const S major2 = half_trace + std::sqrt(gap2 > S(0) ? gap2 : S(0));
  if (!(major2 > S(0)) || !(radius_m > S(0))) return Status::bad_argument;
  const S Z = radius_m / std::sqrt(major2);
  return Vec<S, 3>{s.value().x() * Z, s.value().y() * Z, Z};
}

}  // namespace articam::vision
