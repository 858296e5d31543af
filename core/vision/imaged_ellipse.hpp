#pragma once
/// @file  The ellipse that a flat circular mark is seen as, whole: centre and shape, and how both move.

#include <cmath>

#include "core/math/types.hpp"
#include "core/status.hpp"
#include "core/vision/imaged_circle.hpp"
#include "core/vision/plane_ellipse.hpp"

namespace articam::vision {

/// The whole image of a circle, from the same dual conic. With  a = (c_x, c_y) / c_z,  rho = r / c_z  and the normal's
/// part across the ray  p = (n_x, n_y) - a n_z:
///
///     m = 1 - rho^2 (1 - n_z^2),    k = rho^2 / m,    d = a + p n_z
///     centre = a + k d,             M M^T = k (I + a a^T - p p^T + k d d^T),    det M = k |f| / sqrt(m)
///
/// and f = n_x a_x + n_y a_y + n_z, the cosine to the ray times |(a, 1)|. Only small parts are left to add up, so float
/// keeps its digits; det M, on its own, keeps them where the circle is seen nearly edge on.
template <class S>
class CircleImage {
 public:
  explicit CircleImage(const Circle<S>& circle) noexcept : c_{circle.centre}, n_{circle.normal} {
    status_ = imaged_centre(circle).status();
    rho2_ = circle.radius / c_.z() * (circle.radius / c_.z());
    m_ = S(1) - rho2_ * (S(1) - n_.z() * n_.z());
    k_ = rho2_ / m_;
    a_ = c_.template head<2>() / c_.z();
    p_ = n_.template head<2>() - a_ * n_.z();
    d_ = a_ + p_ * n_.z();
    f_ = n_.template head<2>().dot(a_) + n_.z();
    shape00_ = k_ * (S(1) + a_.x() * a_.x() - p_.x() * p_.x() + k_ * d_.x() * d_.x());
    shape10_ = k_ * (a_.x() * a_.y() - p_.x() * p_.y() + k_ * d_.x() * d_.y());
    m00_ = std::sqrt(shape00_);
    m11_ = k_ * (f_ < S(0) ? -f_ : f_) / (std::sqrt(m_) * m00_);
  }

  /// behind_camera as imaged_centre() has it; ill_conditioned where there is no ellipse: seen edge on, or of no size.
  Status status() const noexcept {
    if (status_ != Status::ok) return status_;
    return m00_ > S(0) && m11_ > S(0) ? Status::ok : Status::ill_conditioned;  // also catches NaN
  }

  PlaneEllipse<S> ellipse() const noexcept {
    PlaneEllipse<S> e;
    e.centre = a_ + k_ * d_;
    e.M << m00_, S(0), shape10_ / m00_, m11_;
    return e;
  }

  /// d (x, y, m00, m10, m11) / d (c, n), each of which may change on its own.
  Mat<S, 5, 6> derivative() const noexcept {
    const Vec<S, 2> ex{S(1), S(0)}, ey{S(0), S(1)};
    const S nz = n_.z(), per_m = S(1) / m_;
    const Vec<S, 2> grown = Vec<S, 2>{shape00_, shape10_} + S(0.5) * k_ * k_ * symmetric(d_, d_);
    const auto by_a = [&](const Vec<S, 2>& e, S n_e) {
      return rate(per_m * e, k_ * per_m * symmetric(e, d_), n_e / f_);
    };
    const auto by_n = [&](const Vec<S, 2>& e, S a_e) {
      return rate(k_ * nz * e, k_ * (k_ * nz * symmetric(e, d_) - symmetric(e, p_)), a_e / f_);
    };
    const Vec<S, 5> by_ax = by_a(ex, n_.x()), by_ay = by_a(ey, n_.y());
    const Vec<S, 5> by_log_rho = rate(S(2) * k_ * per_m * d_, S(2) * per_m * grown, S(3) * per_m - S(1));
    const Vec<S, 2> d_by_nz = p_ - nz * a_;

    Mat<S, 5, 6> D;
    D.col(0) = by_ax / c_.z();
    D.col(1) = by_ay / c_.z();
    D.col(2) = (a_.x() * by_ax + a_.y() * by_ay + by_log_rho) / -c_.z();
    D.col(3) = by_n(ex, a_.x());
    D.col(4) = by_n(ey, a_.y());
    D.col(5) =
        rate(k_ * (d_by_nz - S(2) * k_ * nz * d_),
             k_ * (symmetric(a_, p_) + k_ * symmetric(d_by_nz, d_) - S(2) * nz * grown), S(1) / f_ - S(3) * k_ * nz);
    return D;
  }

 private:
  /// First column of u v^T + v u^T.
  static Vec<S, 2> symmetric(const Vec<S, 2>& u, const Vec<S, 2>& v) noexcept {
    return {S(2) * u.x() * v.x(), u.y() * v.x() + v.y() * u.x()};
  }

  /// From the derivatives of the centre, of the first column of M M^T and of log det M.
  Vec<S, 5> rate(const Vec<S, 2>& centre, const Vec<S, 2>& shape, S log_det) const noexcept {
    const S m00 = S(0.5) * shape.x() / m00_;
    const S m10 = (shape.y() - shape10_ / m00_ * m00) / m00_;
    return (Vec<S, 5>{} << centre, m00, m10, m11_ * (log_det - m00 / m00_)).finished();
  }

  Vec<S, 3> c_, n_;
  Vec<S, 2> a_, p_, d_;
  Status status_;
  S rho2_, m_, k_, f_, shape00_, shape10_, m00_, m11_;
};

/// The circle's image on the metric plane. Its centre is imaged_centre(). Frames {cam}. Errors  of CircleImage.
template <class S>
Result<PlaneEllipse<S>> imaged_ellipse(const Circle<S>& circle) noexcept {
  const CircleImage<S> image{circle};
  if (image.status() != Status::ok) return image.status();
  return image.ellipse();
}

/// Interaction matrix of (x, y, m00, m10, m11):  sdot = L v, v the twist of the camera relative to the object. Its
/// first two rows are imaged_centre_interaction_matrix().
///
/// M as measurements: like the centre they are lengths in which an edge's displacement is linear, so one covariance on
/// the metric plane holds all five and hardly depends on size; and they are smooth where axes and angle are not, at the
/// circle. The entries of M M^T would carry a noise that grows with the size.
/// Shapes, frames, units as interaction_matrix(); errors of CircleImage.
template <class S>
Result<Mat<S, 5, 6>> imaged_ellipse_interaction_matrix(const Circle<S>& circle) noexcept {
  const CircleImage<S> image{circle};
  if (image.status() != Status::ok) return image.status();
  const Mat<S, 5, 6> D = image.derivative();
  const Mat<S, 5, 3> D_c = D.template leftCols<3>(), D_n = D.template rightCols<3>();
  // The camera's twist (v, w) moves c by -v - w x c and turns n by -w x n.
  Mat<S, 5, 6> L;
  L << -D_c, D_c.lazyProduct(math::hat<S>(circle.centre)) + D_n.lazyProduct(math::hat<S>(circle.normal));
  return L;
}

}  // namespace articam::vision
