#pragma once
/// @file  Where a circular mark is, from its image alone: the simple form that equation (7) needs.

#include <cmath>

#include "core/status.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/detection.hpp"

namespace articam::vision {

/// Position of the mark's centre in {cam}, m. Seen along its own ray, a circle's image has the semi-major axis
/// radius / distance whatever its tilt; so the ellipse is turned from the image plane onto the plane across that ray.
/// Bias  of second order in (radius / distance) and tilt; blur shortens the axis and lengthens the distance.
/// Errors  bad_argument for an empty ellipse or radius; outside_domain from the lens model.
template <class S>
Result<Vec<S, 3>> ring_position(const Ellipse& image, S radius_m, const CameraModel<S>& camera) noexcept {
  const auto s = camera.unproject({S(from_q16(image.u_q16)), S(from_q16(image.v_q16))});
  if (!s.ok()) return s.status();
  const S norm = std::sqrt(s.value().squaredNorm() + S(1));
  const Vec<S, 3> ray{s.value().x() / norm, s.value().y() / norm, S(1) / norm};

  Mat<S, 2, 2> M;  // the ellipse on the metric plane
  M << S(from_q16(image.m00_q16)), S(0), S(from_q16(image.m10_q16)), S(from_q16(image.m11_q16));
  M.row(0) /= S(camera.parameters().fx_px);
  M.row(1) /= S(camera.parameters().fy_px);
  const Vec<S, 2> along = M.transpose() * ray.template head<2>();
  // M^T (I - ray ray^T) M / norm^2; its larger eigenvalue is the squared semi-major axis across the ray, at distance 1.
  const Mat<S, 2, 2> shape = (M.transpose() * M - along * along.transpose()) / (norm * norm);
  const S half_trace = S(0.5) * (shape(0, 0) + shape(1, 1));
  const S half_gap = S(0.5) * (shape(0, 0) - shape(1, 1));
  const S major2 = half_trace + std::sqrt(half_gap * half_gap + shape(0, 1) * shape(0, 1));
  if (!(major2 > S(0)) || !(radius_m > S(0))) return Status::bad_argument;
  return Vec<S, 3>{ray * (radius_m / std::sqrt(major2))};
}

}  // namespace articam::vision
