#pragma once
/// @file  Metric image plane <-> pixels, lens distortion included.

#include "core/camera_parameters.hpp"
#include "core/math/types.hpp"
#include "core/status.hpp"

namespace articam::vision {

/// Pinhole with plumb_bob distortion (k1 k2 p1 p2 k3), as ROS and OpenCV define it.
template <class S>
class CameraModel {
 public:
  explicit CameraModel(const CameraParameters& parameters) noexcept : p_{parameters} {}

  const CameraParameters& parameters() const noexcept { return p_; }
  S focal_px() const noexcept { return S(0.5 * (p_.fx_px + p_.fy_px)); }

  /// s (x, y) on the metric plane Z = 1 -> (u_px, v_px).
  Vec<S, 2> project(const Vec<S, 2>& s) const noexcept {
    const Vec<S, 2> d = distort(s);
    return {S(p_.fx_px) * d.x() + S(p_.cx_px), S(p_.fy_px) * d.y() + S(p_.cy_px)};
  }

  /// d (u_px, v_px) / d s at s.
  Mat<S, 2, 2> projection_jacobian(const Vec<S, 2>& s) const noexcept {
    Mat<S, 2, 2> J = distortion_jacobian(s);
    J.row(0) *= S(p_.fx_px);
    J.row(1) *= S(p_.fy_px);
    return J;
  }

  /// Whether the lens model holds at s. Beyond the fold of a barrel distortion it throws points back into the image.
  bool in_domain(const Vec<S, 2>& s) const noexcept {
    const Mat<S, 2, 2> J = distortion_jacobian(s);
    return radial(s.squaredNorm()) > S(0) && J(0, 0) * J(1, 1) - J(0, 1) * J(1, 0) > S(kMinStretch);
  }

  /// (u_px, v_px) -> (x, y) on the metric plane, by Newton's method on the distortion.
  /// Errors  outside_domain where it does not converge in kMaxIterations (beyond the fold of the lens model).
  Result<Vec<S, 2>> unproject(const Vec<S, 2>& pixel) const noexcept {
    const Vec<S, 2> d{(pixel.x() - S(p_.cx_px)) / S(p_.fx_px), (pixel.y() - S(p_.cy_px)) / S(p_.fy_px)};
    if (!math::all_finite(d)) return Status::bad_argument;
    if (!distorted()) return d;
    Vec<S, 2> s = d;
    for (int i = 0; i < kMaxIterations; ++i) {
      const Vec<S, 2> miss = distort(s) - d;
      if (miss.squaredNorm() < kTolerance * kTolerance) return s;
      const Mat<S, 2, 2> J = distortion_jacobian(s);
      const S det = J(0, 0) * J(1, 1) - J(0, 1) * J(1, 0);
      if (!(det > S(kMinStretch))) return Status::outside_domain;
      s -= Vec<S, 2>{J(1, 1) * miss.x() - J(0, 1) * miss.y(), J(0, 0) * miss.y() - J(1, 0) * miss.x()} / det;
    }
    return Status::outside_domain;
  }

 private:
  static constexpr int kMaxIterations = 12;
  static constexpr double kMinStretch = 1e-3;  ///< of areas by the lens; it falls to 0 at the fold
  static constexpr S kTolerance = sizeof(S) == 4 ? S(1e-6) : S(1e-12);  // metric plane; about 1e-3 and 1e-9 px

  bool distorted() const noexcept {
    for (const double k : p_.distortion) {
      if (k != 0) return true;
    }
    return false;
  }

  S radial(S r2) const noexcept {
    const auto [k1, k2, p1, p2, k3] = coefficients();
    return S(1) + r2 * (k1 + r2 * (k2 + r2 * k3));
  }

  Vec<S, 2> distort(const Vec<S, 2>& s) const noexcept {
    const auto [k1, k2, p1, p2, k3] = coefficients();
    const S x = s.x(), y = s.y(), r2 = x * x + y * y;
    const S scale = radial(r2);
    return {x * scale + S(2) * p1 * x * y + p2 * (r2 + S(2) * x * x),
            y * scale + p1 * (r2 + S(2) * y * y) + S(2) * p2 * x * y};
  }

  Mat<S, 2, 2> distortion_jacobian(const Vec<S, 2>& s) const noexcept {
    const auto [k1, k2, p1, p2, k3] = coefficients();
    const S x = s.x(), y = s.y(), r2 = x * x + y * y;
    const S scale = radial(r2);
    const S slope = S(2) * (k1 + r2 * (S(2) * k2 + r2 * S(3) * k3));  // d radial / d r2, times 2
    Mat<S, 2, 2> J;
    J << scale + slope * x * x + S(2) * p1 * y + S(6) * p2 * x, slope * x * y + S(2) * p1 * x + S(2) * p2 * y,
        slope * x * y + S(2) * p1 * x + S(2) * p2 * y, scale + slope * y * y + S(6) * p1 * y + S(2) * p2 * x;
    return J;
  }

  std::array<S, 5> coefficients() const noexcept {
    return {S(p_.distortion[0]), S(p_.distortion[1]), S(p_.distortion[2]), S(p_.distortion[3]), S(p_.distortion[4])};
  }

  CameraParameters p_;
};

}  // namespace articam::vision
