#include "core/vision/imaged_ellipse.hpp"

#include <cmath>

#include "core/math/so3.hpp"

namespace articam::vision {
namespace {

// The terms of the header's equations. Only small parts are left to add up, so float keeps its digits; det M, on its
// own, keeps them where the circle is seen nearly edge on.
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

}  // namespace

template <class S>
Result<PlaneEllipse<S>> imaged_ellipse(const Circle<S>& circle) noexcept {
  const CircleImage<S> image{circle};
  if (image.status() != Status::ok) return image.status();
  return image.ellipse();
}

template <class S>
Result<MovingEllipse<S>> moving_ellipse(const Circle<S>& circle) noexcept {
  const CircleImage<S> image{circle};
  if (image.status() != Status::ok) return image.status();
  const Mat<S, 5, 6> D = image.derivative();
  const Mat<S, 5, 3> D_c = D.template leftCols<3>(), D_n = D.template rightCols<3>();
  // The camera's twist (v, w) moves c by -v - w x c and turns n by -w x n.
  MovingEllipse<S> moving;
  moving.ellipse = image.ellipse();
  moving.L << -D_c, D_c.lazyProduct(math::hat<S>(circle.centre)) + D_n.lazyProduct(math::hat<S>(circle.normal));
  return moving;
}

template Result<PlaneEllipse<float>> imaged_ellipse(const Circle<float>&) noexcept;
template Result<PlaneEllipse<double>> imaged_ellipse(const Circle<double>&) noexcept;
template Result<MovingEllipse<float>> moving_ellipse(const Circle<float>&) noexcept;
template Result<MovingEllipse<double>> moving_ellipse(const Circle<double>&) noexcept;

}  // namespace articam::vision
