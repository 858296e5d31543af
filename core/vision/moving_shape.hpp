#pragma once
/// @file  Size and shape of a flat circular mark's image, and how they change as it moves.

#include <cmath>

#include "core/vision/plate.hpp"

namespace articam::vision {

/// Of a circle's dual conic C, see imaged_centre(): the imaged centre s, 1 / C_zz, and how far the circle's own centre
/// c lies off s at its depth,  alpha = (c_x, c_y) - c_z s, without the difference of large numbers.
template <class S>
struct ConicCentre {
  S s_x, s_y, per_C_zz, alpha_x, alpha_y;

  [[gnu::always_inline]] ConicCentre(const Plate<S>& plate, const math::Triple<S>& c, S x, S y, S per_zz) noexcept
      : s_x{x},
        s_y{y},
        per_C_zz{per_zz},
        alpha_x{(c.x * plate.N_z - c.z * plate.at_pole.x) * per_zz},
        alpha_y{(c.y * plate.N_z - c.z * plate.at_pole.y) * per_zz} {}
};

/// What (m00, m10, m11) have of v_y: m00 has nothing.
template <class S>
struct LastTwo {
  S y, z;
  friend constexpr S dot(const LastTwo& a, const math::Triple<S>& b) noexcept { return a.y * b.y + a.z * b.z; }
  friend constexpr S dot(const math::Triple<S>& a, const LastTwo& b) noexcept { return dot(b, a); }
  friend constexpr S dot(const LastTwo& a, const LastTwo& b) noexcept { return a.y * b.y + a.z * b.z; }
};

/// M of imaged_ellipse(), and how it changes when the circle moves by v + omega x arm, turning by omega.
///
/// With  e_x = (1, 0, -s_x),  e_y = (0, 1, -s_y),  alpha = (e_x, e_y) . c  and  beta = (e_x, e_y) . n:
///
///     M M^T = Q,   Q_ij C_zz = r^2 (d_ij + s_i s_j - beta_i beta_j) - alpha_i alpha_j
///     det M = r^2 |n . c| C_zz^(-3/2)
///     -C_zz dQ_ij = e_i . (alpha_j dc + r^2 beta_j dn) + e_j . (alpha_i dc + r^2 beta_i dn) + Q_ij dC_zz
///     d(n . c) = n . v + (n x t) . omega,   t = c - arm the point it turns about
///
/// with C and s of imaged_centre(). Only small parts are left to add up, so float keeps its digits; det M, on its own,
/// keeps them where the circle is seen nearly edge on.
/// Shapes  f.x: what (m00, m10, m11) have of v_x; w.x: of omega_x.  Frames  {cam}.
template <class S>
class MovingShape {
 public:
  using T = math::Triple<S>;
  S m00, m10, m11;
  struct {
    T x;
    LastTwo<S> y;
    T z;
  } f;
  math::Axes<S> w;

  /// M of the circle of a plate at c, m, in front of the camera.
  [[gnu::always_inline]] MovingShape(const Plate<S>& plate, const T& c, const ConicCentre<S>& conic) noexcept
      : conic_{conic} {
    const auto& [s_x, s_y, per_C_zz, alpha_x, alpha_y] = conic_;
    const T& n = plate.n;
    const S r2 = plate.r * plate.r;
    beta_x_ = n.x - s_x * n.z, beta_y_ = n.y - s_y * n.z;
    Q_xx_ = (r2 * (S(1) + s_x * s_x - beta_x_ * beta_x_) - alpha_x * alpha_x) * per_C_zz;
    Q_xy_ = (r2 * (s_x * s_y - beta_x_ * beta_y_) - alpha_x * alpha_y) * per_C_zz;
    n_c_ = dot(n, c);
    m00 = std::sqrt(Q_xx_);
    per_m00_ = S(1) / m00;
    m10 = Q_xy_ * per_m00_;
    m11 = r2 * std::abs(n_c_) * per_C_zz * std::sqrt(per_C_zz) * per_m00_;
  }
  /// False where there is no ellipse: seen edge on, of no size, or not a number.
  bool exists() const noexcept { return m00 * m11 > S(0); }

  /// Sets the rows, times `factor`.
  [[gnu::always_inline]] void move(const Plate<S>& plate, const T& c, const T& arm, const T& n_t, S factor) noexcept {
    const auto& [n, r, rn, at_pole, N_z, nearest] = plate;
    const auto& [s_x, s_y, per_C_zz, alpha_x, alpha_y] = conic_;
    // Of m00; of m10 but for the change of m00; of log det M times m11, but for that of m00.
    const S scale = -factor * per_C_zz * per_m00_, r2_scale = r * r * scale;
    const S a_x = scale * alpha_x, a_y = scale * alpha_y;
    const S q_xx = scale * Q_xx_, q_xy = S(2) * scale * Q_xy_;
    const T A_x = a_x * arm + (r2_scale * beta_x_) * n, A_y = a_y * arm + (r2_scale * beta_y_) * n;
    const S B_x = c.z * arm.x + at_pole.x, B_y = c.z * arm.y + at_pole.y;
    const T w_0{q_xx * B_y - A_x.y * s_x, A_x.z + A_x.x * s_x - q_xx * B_x, -A_x.y};
    const T w_1{q_xy * B_y - A_y.y * s_x - A_x.y * s_y - A_x.z, A_y.z + A_y.x * s_x + A_x.x * s_y - q_xy * B_x,
                A_x.x - A_y.y};
    const S f_0z = q_xx * c.z - a_x * s_x, f_1z = q_xy * c.z - a_y * s_x - a_x * s_y;
    const S of_m11 = factor * m11, of_det = of_m11 / n_c_, of_depth = S(3) * per_C_zz * of_m11;
    const S share_1 = m10 * per_m00_, share_2 = m11 * per_m00_;
    f.x = {a_x, a_y - share_1 * a_x, of_det * n.x - share_2 * a_x};
    f.y = {a_x, of_det * n.y};
    f.z = {f_0z, f_1z - share_1 * f_0z, of_det * n.z - of_depth * c.z - share_2 * f_0z};
    w.x = {w_0.x, w_1.x - share_1 * w_0.x, of_det * n_t.x - of_depth * B_y - share_2 * w_0.x};
    w.y = {w_0.y, w_1.y - share_1 * w_0.y, of_det * n_t.y + of_depth * B_x - share_2 * w_0.y};
    w.z = {w_0.z, w_1.z - share_1 * w_0.z, of_det * n_t.z - share_2 * w_0.z};
  }

 private:
  ConicCentre<S> conic_;
  S beta_x_, beta_y_, Q_xx_, Q_xy_, n_c_, per_m00_;
};

}  // namespace articam::vision
