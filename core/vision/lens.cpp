#include "core/vision/lens.hpp"

#include <Eigen/LU>

#include "core/math/trigonometry.hpp"

namespace articam::vision {

template <class S>
Lens<S>::Lens(const CameraParameters& camera) noexcept : model_{camera.distortion_model} {
  for (std::size_t i = 0; i < num_coefficients(model_); ++i) k_[i] = S(camera.distortion[i]);
  if (model_ != DistortionModel::equidistant) p_ = {k_[2], k_[3]};
  tangential_ = S(3) * (std::abs(p_[0]) + std::abs(p_[1]));
  distorts_ = model_ == DistortionModel::equidistant;
  for (const S k : k_) distorts_ = distorts_ || k != S(0);
  if (distorts_) reach_ = farthest_radius();
}

template <class S>
LensImage<S> Lens<S>::image(const Vec<S, 2>& s) const noexcept {
  const S x = s.x(), y = s.y(), r2 = x * x + y * y;
  const auto [p1, p2] = p_;
  const auto [scale, slope] = radial(r2);
  const S mixed = slope * x * y + S(2) * p1 * x + S(2) * p2 * y;
  LensImage<S> at;
  at.d = {x * scale + S(2) * p1 * x * y + p2 * (r2 + S(2) * x * x),
          y * scale + p1 * (r2 + S(2) * y * y) + S(2) * p2 * x * y};
  at.J << scale + slope * x * x + S(2) * p1 * y + S(6) * p2 * x, mixed,  //
      mixed, scale + slope * y * y + S(6) * p1 * y + S(2) * p2 * x;
  at.in_domain = r2 <= reach_ * reach_ && at.J.determinant() > S(0);
  return at;
}

template <class S>
S Lens<S>::farthest_radius() const noexcept {
  constexpr S kMinGrowth = S(1e-3);
  constexpr int kMost_deg = 85, kHalvings = 20;
  const auto grows = [this](S r) {
    const auto [scale, slope] = radial(r * r);
    return scale > S(0) && (scale + slope * r * r) * (S(1) + r * r) > kMinGrowth;  // false on NaN
  };
  S low{0};
  for (int degree = 1; degree <= kMost_deg; ++degree) {
    const auto turn = math::sin_cos(S(0.017453292519943295) * static_cast<S>(degree));
    S high = turn.sin / turn.cos;
    if (grows(high)) {
      low = high;
      continue;
    }
    for (int i = 0; i < kHalvings; ++i) {
      const S middle = S(0.5) * (low + high);
      (grows(middle) ? low : high) = middle;
    }
    break;
  }
  return low;
}

template class Lens<float>;
template class Lens<double>;

}  // namespace articam::vision
