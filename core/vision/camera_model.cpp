#include "core/vision/camera_model.hpp"

#include <Eigen/LU>

namespace articam::vision {
namespace {

constexpr int kMaxIterations = 12, kMaxRadiusIterations = 40;
// On the metric plane, at its centre: times a focal length of 500 px, 2.5e-4 and 2.5e-10 px.
template <class S>
constexpr S kTolerance = sizeof(S) == 4 ? S(5e-7) : S(5e-13);

}  // namespace

template <class S>
CameraModel<S>::CameraModel(const CameraParameters& parameters) noexcept
    : p_{parameters},
      f_{S(p_.fx_px), S(p_.fy_px)},
      c_{S(p_.cx_px), S(p_.cy_px)},
      focal_px_{S(0.5 * (p_.fx_px + p_.fy_px))},
      lens_{parameters} {}

template <class S>
Result<Projection<S>> CameraModel<S>::project_with_slope(const Vec<S, 2>& s) const noexcept {
  if (!lens_.distorts()) return Projection<S>{f_.cwiseProduct(s) + c_, f_.asDiagonal()};
  const LensImage<S> image = lens_.image(s);
  if (!image.in_domain) return Status::outside_domain;
  return Projection<S>{f_.cwiseProduct(image.d) + c_, f_.asDiagonal() * image.J};
}

template <class S>
Result<Vec<S, 2>> CameraModel<S>::unproject(const Vec<S, 2>& pixel) const noexcept {
  const Vec<S, 2> d = (pixel - c_).cwiseQuotient(f_);
  if (!math::all_finite(d)) return Status::bad_argument;
  if (!lens_.distorts()) return d;
  const S radius = d.norm(), tolerance = kTolerance<S> * (S(1) + radius);
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

template <class S>
S CameraModel<S>::undistorted_radius(S distorted) const noexcept {
  S low{0}, high = lens_.reach();
  if (!(distorted > S(0))) return S(0);
  S r = distorted < high ? distorted : high;
  for (int i = 0; i < kMaxRadiusIterations; ++i) {
    const auto [scale, slope] = lens_.radial(r * r);
    const S miss = r * scale - distorted;
    if (miss < kTolerance<S> && miss > -kTolerance<S>) break;
    (miss < S(0) ? low : high) = r;
    r -= miss / (scale + slope * r * r);
    if (!(r > low && r < high)) r = S(0.5) * (low + high);
  }
  return r;
}

template class CameraModel<float>;
template class CameraModel<double>;

}  // namespace articam::vision
