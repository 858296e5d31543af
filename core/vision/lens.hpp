#pragma once
/// @file  The lens models: how far from the axis a ray meets the image.

#include <array>
#include <cmath>
#include <cstddef>

#include "core/camera_parameters.hpp"
#include "core/math/trigonometry.hpp"
#include "core/math/types.hpp"

namespace articam::vision {

/// The radial part of a lens takes s to scale s, its Jacobian is  scale I + slope s s^T;  slope = 2 d scale / d r^2.
template <class S>
struct RadialScale {
  S scale, slope;
};

/// Coefficients in the order of CameraParameters::distortion.
template <class S>
using LensCoefficients = std::array<S, 8>;

/// plumb_bob and, with the last three, rational_polynomial:
///
///     scale = (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6)
///
/// Source  OpenCV 4, module calib3d, "Detailed description".
template <class S>
RadialScale<S> polynomial_scale(const LensCoefficients<S>& c, S r2) noexcept {
  const auto [k1, k2, p1, p2, k3, k4, k5, k6] = c;
  const S above = S(1) + r2 * (k1 + r2 * (k2 + r2 * k3)), below = S(1) + r2 * (k4 + r2 * (k5 + r2 * k6));
  const S scale = above / below;
  const S above_rate = k1 + r2 * (S(2) * k2 + r2 * S(3) * k3), below_rate = k4 + r2 * (S(2) * k5 + r2 * S(3) * k6);
  return {scale, S(2) * (above_rate - scale * below_rate) / below};
}

/// equidistant:  scale = theta_d / r,  theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8),
/// theta = atan r.  Source  OpenCV 4, module calib3d, namespace fisheye (Kannala & Brandt, IEEE PAMI 28(8), 2006).
template <class S>
RadialScale<S> equidistant_scale(const LensCoefficients<S>& k, S r2) noexcept {
  if (!(r2 > S(1e-12))) return {S(1), S(2) * (k[0] - S(1) / S(3))};  // the limit; r^2 is also a divisor below
  const S r = std::sqrt(r2);
  const S theta = math::atan2(r, S(1));
  const S t2 = theta * theta;
  const S scale = theta * (S(1) + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3])))) / r;
  const S rate = S(1) + t2 * (S(3) * k[0] + t2 * (S(5) * k[1] + t2 * (S(7) * k[2] + t2 * S(9) * k[3])));
  return {scale, (rate / (S(1) + r2) - scale) / r2};
}

/// Where a lens takes a point, and how it stretches there.
template <class S>
struct LensImage {
  Vec<S, 2> d;
  Mat<S, 2, 2> J;    ///< d d / d s
  bool in_domain{};  ///< without it the rest is without meaning
};

/// The lens of a camera between the metric planes before it (s) and behind it (d). Compiled for float and double.
template <class S>
class Lens {
 public:
  explicit Lens(const CameraParameters& camera) noexcept;

  bool distorts() const noexcept { return distorts_; }
  /// The largest |s| that the model holds for; without meaning where the lens does not distort.
  S reach() const noexcept { return reach_; }

  /// The tangential part is at most this times r^2.
  S tangential() const noexcept { return tangential_; }

  RadialScale<S> radial(S r2) const noexcept {
    return model_ == DistortionModel::equidistant ? equidistant_scale(k_, r2) : polynomial_scale(k_, r2);
  }

  LensImage<S> image(const Vec<S, 2>& s) const noexcept;

 private:
  /// Where the distorted radius stops growing with the angle to the axis, the fold, at most 85 degrees off it.
  S farthest_radius() const noexcept;

  DistortionModel model_;
  bool distorts_{};
  LensCoefficients<S> k_{};
  std::array<S, 2> p_{};  // of the polynomial lenses
  S tangential_{}, reach_{};
};

}  // namespace articam::vision
