#pragma once
/// @file  Metric image plane <-> pixels, lens distortion included.

#include <Eigen/LU>

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

/// Pinhole and lens (lens.hpp), as ROS and OpenCV define them.
///
/// Domain  a lens that distorts holds up to its first fold, where a larger angle to the axis would no longer be seen
///         farther out, and at most to 85 degrees; a pinhole holds everywhere.
template <class S>
class CameraModel {
 public:
  explicit CameraModel(const CameraParameters& parameters) noexcept
      : p_{parameters},
        f_{S(p_.fx_px), S(p_.fy_px)},
        c_{S(p_.cx_px), S(p_.cy_px)},
        focal_px_{S(0.5 * (p_.fx_px + p_.fy_px))},
        lens_{parameters} {}

  const CameraParameters& parameters() const noexcept { return p_; }
  S focal_px() const noexcept { return focal_px_; }
  bool distorts() const noexcept { return lens_.distorts(); }

  /// s (x, y) on the metric plane Z = 1 -> (u_px, v_px). Beyond the domain without meaning.
  Vec<S, 2> project(const Vec<S, 2>& s) const noexcept {
    return f_.cwiseProduct(lens_.distorts() ? lens_.image(s).d : s) + c_;
  }

  /// The same with its slope. Errors  outside_domain.
  Result<Projection<S>> project_with_slope(const Vec<S, 2>& s) const noexcept {
    if (!lens_.distorts()) return Projection<S>{f_.cwiseProduct(s) + c_, f_.asDiagonal()};
    const LensImage<S> image = lens_.image(s);
    if (!image.in_domain) return Status::outside_domain;
    return Projection<S>{f_.cwiseProduct(image.d) + c_, f_.asDiagonal() * image.J};
  }

  bool in_domain(const Vec<S, 2>& s) const noexcept { return !lens_.distorts() || lens_.image(s).in_domain; }

  /// (u_px, v_px) -> (x, y) on the metric plane.
  /// Errors  outside_domain where no s of the domain is seen; bad_argument when the pixel is not a number.
  Result<Vec<S, 2>> unproject(const Vec<S, 2>& pixel) const noexcept {
    const Vec<S, 2> d = (pixel - c_).cwiseQuotient(f_);
    if (!math::all_finite(d)) return Status::bad_argument;
    if (!lens_.distorts()) return d;
    const S radius = d.norm(), tolerance = kTolerance * (S(1) + radius);
    S r = undistorted_radius(radius);
    if (lens_.tangential() > S(0)) r = undistorted_radius(radius - lens_.tangential() * r * r);
    Vec<S, 2> s = radius > S(0) ? Vec<S, 2>{d * (r / radius)} : d;
    for (int i = 0; i < kMaxIterations; ++i) {  // Newton's method; from inside, so that no fold is leapt
      const LensImage<S> image = lens_.image(s);
      if (!image.in_domain) break;
      const Vec<S, 2> miss = image.d - d;
      if (miss.squaredNorm() < tolerance * tolerance) return s;
      s -= image.J.inverse() * miss;
    }
    return Status::outside_domain;
  }

 private:
  static constexpr int kMaxIterations = 12, kMaxRadiusIterations = 40;
  // On the metric plane, at its centre: times a focal length of 500 px, 2.5e-4 and 2.5e-10 px.
  static constexpr S kTolerance = sizeof(S) == 4 ? S(5e-7) : S(5e-13);

  /// The r up to reach() that the radial part takes to `distorted`, or reach() where there is none: Newton's method
  /// inside a bracket that it halves where it would leave it.
  S undistorted_radius(S distorted) const noexcept {
    S low{0}, high = lens_.reach();
    if (!(distorted > S(0))) return S(0);
    S r = distorted < high ? distorted : high;
    for (int i = 0; i < kMaxRadiusIterations; ++i) {
      const auto [scale, slope] = lens_.radial(r * r);
      const S miss = r * scale - distorted;
      if (miss < kTolerance && miss > -kTolerance) break;
      (miss < S(0) ? low : high) = r;
      r -= miss / (scale + slope * r * r);
      if (!(r > low && r < high)) r = S(0.5) * (low + high);
    }
    return r;
  }

  CameraParameters p_;
  Vec<S, 2> f_, c_;  // px
  S focal_px_;
  Lens<S> lens_;
};

}  // namespace articam::vision
