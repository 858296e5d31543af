#include "core/vision/lens_ellipse.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace articam::vision {
namespace {

/// How a curve lies about the ellipse (centre, M), in radii: the ellipse (centre + M shift, M (I + stretch)) fits it
/// better, best where both are 0.
template <class S>
struct EllipseMiss {
  Vec<S, 2> shift{Vec<S, 2>::Zero()};
  Mat<S, 2, 2> stretch{Mat<S, 2, 2>::Zero()};
};

/// Of the image of `on_plane` about `in_pixels`.
/// Errors  outside_domain when a part of the edge lies outside the lens model's domain.
template <class S>
Result<EllipseMiss<S>> miss_of_image(const PlaneEllipse<S>& on_plane, const PlaneEllipse<S>& in_pixels,
                                     const CameraModel<S>& camera) noexcept {
  constexpr int kPoints = 16;  // the offsets' harmonics up to the 13th do not touch the five
  // cos of 0 to 4 sixteenths of a turn, then by symmetry
  constexpr std::array<S, 5> kCos{S(1), S(0.92387953251128675613), S(0.70710678118654752440), S(0.38268343236508977173),
                                  S(0)};
  const auto cosine = [&](int k) {
    k &= kPoints - 1;
    if (k > kPoints / 2) k = kPoints - k;
    return k > kPoints / 4 ? -kCos[static_cast<std::size_t>(kPoints / 2 - k)] : kCos[static_cast<std::size_t>(k)];
  };
  const Mat<S, 2, 2> to_radii = in_pixels.M.inverse();
  S turn{0}, mean{0};
  Vec<S, 2> first = Vec<S, 2>::Zero(), second = Vec<S, 2>::Zero();
  for (int k = 0; k < kPoints; ++k) {
    const Vec<S, 2> u{cosine(k), cosine(k - kPoints / 4)}, u_dot{-u.y(), u.x()};
    const auto edge = camera.project_with_slope(on_plane.centre + on_plane.M * u);
    if (!edge.ok()) return edge.status();
    const Vec<S, 2> w = to_radii * (edge.value().pixel - in_pixels.centre);
    const Vec<S, 2> w_dot = to_radii * (edge.value().J * (on_plane.M * u_dot));
    const S radius = w.norm();
    const Vec<S, 2> ray = w / radius;
    const S angle = (w.x() * w_dot.y() - w.y() * w_dot.x()) / (radius * radius);  // of w, that this point stands for
    const S offset = (radius - S(1)) * angle;
    turn += angle;
    mean += offset;
    first += offset * ray;
    second += offset * Vec<S, 2>{ray.x() * ray.x() - ray.y() * ray.y(), S(2) * ray.x() * ray.y()};
  }
  EllipseMiss<S> miss;
  miss.shift = S(2) * first / turn;
  second *= S(2);
  miss.stretch << mean + second.x(), second.y(), second.y(), mean - second.x();
  miss.stretch /= turn;
  return miss;
}

/// Iterations of both directions: each leaves a part of the miss that is the lens's change of scale over the ellipse.
constexpr int kMaxEllipseIterations = 20;

/// Whether one more step, which leaves a tenth of it at most, is lost in the rounding of pixels.
template <class S>
bool is_small(const EllipseMiss<S>& miss, const PlaneEllipse<S>& in_pixels) noexcept {
  constexpr S kTolerance_px = sizeof(S) == 4 ? S(1e-3) : S(1e-9);
  return (in_pixels.M * miss.shift).squaredNorm() + (in_pixels.M * miss.stretch).squaredNorm() <
         kTolerance_px * kTolerance_px;
}

}  // namespace

template <class S>
Result<PlaneEllipse<S>> distorted_ellipse(const PlaneEllipse<S>& on_plane, const CameraModel<S>& camera) noexcept {
  const auto centre = camera.project_with_slope(on_plane.centre);
  if (!centre.ok()) return centre.status();
  PlaneEllipse<S> in_pixels{centre.value().pixel, lower_triangular<S>(centre.value().J * on_plane.M)};
  if (!camera.distorts()) return in_pixels;
  for (int i = 0; i < kMaxEllipseIterations; ++i) {
    const auto miss = miss_of_image(on_plane, in_pixels, camera);
    if (!miss.ok()) return miss.status();
    const bool last = is_small(miss.value(), in_pixels);
    in_pixels.centre += in_pixels.M * miss.value().shift;
    in_pixels.M = lower_triangular<S>(in_pixels.M + in_pixels.M * miss.value().stretch);
    if (last) return in_pixels;
  }
  return Status::ill_conditioned;
}

template <class S>
Result<PlaneEllipse<S>> undistorted_ellipse(const PlaneEllipse<S>& in_pixels, const CameraModel<S>& camera) noexcept {
  if (!(in_pixels.M(0, 0) > S(0) && in_pixels.M(1, 1) > S(0)) || !math::all_finite(in_pixels.M)) {
    return Status::bad_argument;
  }
  const auto centre = camera.unproject(in_pixels.centre);
  if (!centre.ok()) return centre.status();
  const auto there = camera.project_with_slope(centre.value());
  if (!there.ok()) return there.status();
  const Mat<S, 2, 2> J = there.value().J, to_plane = J.inverse() * in_pixels.M;  // radii -> metric plane
  PlaneEllipse<S> on_plane{centre.value(), lower_triangular<S>(to_plane)};
  if (!camera.distorts()) return on_plane;
  const Mat<S, 2, 2> to_radii = in_pixels.M.inverse();
  for (int i = 0; i < kMaxEllipseIterations; ++i) {
    const auto miss = miss_of_image(on_plane, in_pixels, camera);
    if (!miss.ok()) return miss.status();
    const bool last = is_small(miss.value(), in_pixels);
    on_plane.M = lower_triangular<S>(on_plane.M - to_plane * miss.value().stretch * to_radii * J * on_plane.M);
    on_plane.centre -= to_plane * miss.value().shift;
    if (last) return on_plane;
  }
  return Status::ill_conditioned;
}

template <class S>
Result<PlaneEllipse<S>> undistorted_ellipse(const Ellipse& image, const CameraModel<S>& camera) noexcept {
  return undistorted_ellipse(from_q16<S>(image), camera);
}

template Result<PlaneEllipse<float>> distorted_ellipse(const PlaneEllipse<float>&, const CameraModel<float>&) noexcept;
template Result<PlaneEllipse<double>> distorted_ellipse(const PlaneEllipse<double>&,
                                                        const CameraModel<double>&) noexcept;
template Result<PlaneEllipse<float>> undistorted_ellipse(const PlaneEllipse<float>&,
                                                         const CameraModel<float>&) noexcept;
template Result<PlaneEllipse<double>> undistorted_ellipse(const PlaneEllipse<double>&,
                                                          const CameraModel<double>&) noexcept;
template Result<PlaneEllipse<float>> undistorted_ellipse(const Ellipse&, const CameraModel<float>&) noexcept;
template Result<PlaneEllipse<double>> undistorted_ellipse(const Ellipse&, const CameraModel<double>&) noexcept;

}  // namespace articam::vision
