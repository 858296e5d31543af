#pragma once
/// @file  An ellipse on the metric plane <-> the ellipse that fits its image through the lens best.

#include "core/status.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/plane_ellipse.hpp"

namespace articam::vision {

/// The ellipse on the metric plane Z = 1 whose image in pixels is `image`.
/// Errors  outside_domain from the lens model.
template <class S>
Result<PlaneEllipse<S>> undistorted_ellipse(const Ellipse& image, const CameraModel<S>& camera) noexcept {
  const PlaneEllipse<S> in_pixels = from_q16<S>(image);
  const auto s = camera.unproject(in_pixels.centre);
  if (!s.ok()) return s.status();
  const Mat<S, 2, 2> J = camera.projection_jacobian(s.value());
  return PlaneEllipse<S>{s.value(), lower_triangular<S>(inverse(J) * in_pixels.M)};
}

}  // namespace articam::vision
