#pragma once
/// @file  Metric image plane <-> pixels, lens distortion included.

#include "core/camera_parameters.hpp"
#include "core/math/types.hpp"
#include "core/status.hpp"
#include "core/vision/lens.hpp"

namespace articam::vision {

/// Where a camera sees a point of the metric plane.
template <class S>
struct Projection {
  Vec<S, 2> pixel;
  Mat<S, 2, 2> J;  ///< d (u_px, v_px) / d s
};

/// Pinhole and lens (lens.hpp), as ROS and OpenCV define them. Compiled for float and double.
///
/// Domain  a lens that distorts holds up to its first fold, where a larger angle to the axis would no longer be seen
///         farther out, and at most to 85 degrees; a pinhole holds everywhere.
template <class S>
class CameraModel {
 public:
  explicit CameraModel(const CameraParameters& parameters) noexcept;

  const CameraParameters& parameters() const noexcept { return p_; }
  S focal_px() const noexcept { return focal_px_; }
  bool distorts() const noexcept { return lens_.distorts(); }

  /// s (x, y) on the metric plane Z = 1 -> (u_px, v_px). Beyond the domain without meaning.
  Vec<S, 2> project(const Vec<S, 2>& s) const noexcept {
    return f_.cwiseProduct(lens_.distorts() ? lens_.image(s).d : s) + c_;
  }

  /// The same with its slope. Errors  outside_domain.
  Result<Projection<S>> project_with_slope(const Vec<S, 2>& s) const noexcept;

  bool in_domain(const Vec<S, 2>& s) const noexcept { return !lens_.distorts() || lens_.image(s).in_domain; }

  /// (u_px, v_px) -> (x, y) on the metric plane.
  /// Errors  outside_domain where no s of the domain is seen; bad_argument when the pixel is not a number.
  Result<Vec<S, 2>> unproject(const Vec<S, 2>& pixel) const noexcept;

 private:
  /// The r up to reach() that the radial part takes to `distorted`, or reach() where there is none: Newton's method
  /// inside a bracket that it halves where it would leave it.
  S undistorted_radius(S distorted) const noexcept;

  CameraParameters p_;
  Vec<S, 2> f_, c_;  // px
  S focal_px_;
  Lens<S> lens_;
};

}  // namespace articam::vision
