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

  /// d (x, y, m00, m10, m11) / dt while the centre moves by c_dot and the normal by n_dot.
  Vec<S, 5> rate(const Vec<S, 3>& c_dot, const Vec<S, 3>& n_dot) const noexcept {
    const S growth = -c_dot.z() / c_.z();  // of rho, by rho
    const Vec<S, 2> a_dot = (c_dot.template head<2>() - a_ * c_dot.z()) / c_.z();
    const Vec<S, 2> p_dot = n_dot.template head<2>() - a_dot * n_.z() - a_ * n_dot.z();
    const Vec<S, 2> d_dot = a_dot + p_dot * n_.z() + p_ * n_dot.z();
    const S f_dot = n_dot.template head<2>().dot(a_) + n_.template head<2>().dot(a_dot) + n_dot.z();
    const S m_dot = S(2) * rho2_ * (n_.z() * n_dot.z() - growth * (S(1) - n_.z() * n_.z()));
    const S k_growth = S(2) * growth - m_dot / m_;  // of k, by k

    const auto shape_dot = [&](int i, int j, S shape) {
      return k_growth * (shape + k_ * k_ * d_[i] * d_[j]) +
             k_ * (a_dot[i] * a_[j] + a_[i] * a_dot[j] - p_dot[i] * p_[j] - p_[i] * p_dot[j] +
                   k_ * (d_dot[i] * d_[j] + d_[i] * d_dot[j]));
    };
    const S m10 = shape10_ / m00_;
    const S m00_dot = shape_dot(0, 0, shape00_) / (S(2) * m00_);
    const S m10_dot = (shape_dot(1, 0, shape10_) - m10 * m00_dot) / m00_;
    const S m11_dot = m11_ * (k_growth - m_dot / (S(2) * m_) - m00_dot / m00_ + f_dot / f_);
    const Vec<S, 2> centre_dot = a_dot + k_ * (k_growth * d_ + d_dot);
    return (Vec<S, 5>{} << centre_dot, m00_dot, m10_dot, m11_dot).finished();
  }

 private:
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
  Mat<S, 5, 6> L;
  for (int i = 0; i < 3; ++i) {  // the camera's twist (v, w) moves c by -v - w x c and turns n by -w x n
    const Vec<S, 3> unit = Vec<S, 3>::Unit(i);
    L.col(i) = image.rate(-unit, Vec<S, 3>::Zero());
    L.col(3 + i) = image.rate(circle.centre.cross(unit), circle.normal.cross(unit));
  }
  return L;
}

}  // namespace articam::vision
