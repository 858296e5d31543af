#pragma once
/// @file  What the marks on a body say about how the body has to move.

#include <cstddef>

#include "core/math/robust_weights.hpp"
#include "core/math/triple.hpp"
#include "core/tracker/associate.hpp"
#include "core/vision/interaction_matrix.hpp"

namespace articam::tracker {

/// A marker's circle as the turning point sees it.
template <class S>
struct PlacedMark {
  math::Triple<S> arm;    ///< m, from the turning point to its centre, along the axes of {cam}
  const Match<S>* match;  ///< whether and where it was seen
};

/// A twist's half of a linear function: force and torque, so to speak.
template <class S>
struct Wrench {
  math::Triple<S> force{}, torque{};

  constexpr Wrench& operator+=(const Wrench& b) noexcept {
    force += b.force, torque += b.torque;
    return *this;
  }
};

/// The normal equations of one body's twist (v, omega), a point at `arm` moving by v + omega x arm:
///
///     1/2 sum w |e + A (v, omega)|^2  =  1/2 (v, omega)^T H (v, omega) - pull^T (v, omega) + constant
///
/// They add up: of marks on one body, and of bodies that move as one. A mark costs the same on any body of any object,
/// and nothing here depends on the model.
///
/// Shapes  H 6x6 in 3x3 blocks: vv and ww symmetric, vw full.  Frames  along the axes of {cam}.
/// Units   m, rad and the metric image plane, divided by the marks' variances.
template <class S>
struct BodyInformation {
  struct Symmetric {
    S xx{}, yy{}, zz{}, xy{}, xz{}, yz{};
    constexpr math::Triple<S> operator*(const math::Triple<S>& v) const noexcept {
      return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
    }
    constexpr Symmetric& operator+=(const Symmetric& b) noexcept {
      xx += b.xx, yy += b.yy, zz += b.zz, xy += b.xy, xz += b.xz, yz += b.yz;
      return *this;
    }
  };
  Symmetric vv{}, ww{};
  math::Axes<S> vw{};  ///< its rows: of v_x, v_y, v_z
  Wrench<S> pull{};    ///< -A^T w e
  Wrench<S> scale{};   ///< what the twist has in common with the marks' scale; see shape_information.hpp

  BodyInformation& operator+=(const BodyInformation& b) noexcept {
    vv += b.vv, ww += b.ww;
    vw.x += b.vw.x, vw.y += b.vw.y, vw.z += b.vw.z;
    pull += b.pull, scale += b.scale;
    return *this;
  }
  /// Adds one equation's  weight a a^T,  a being (f, w).
  constexpr void add_row(const math::Triple<S>& f, const math::Triple<S>& w, S weight) noexcept {
    const math::Triple<S> F = weight * f, W = weight * w;
    vv += {F.x * f.x, F.y * f.y, F.z * f.z, F.x * f.y, F.x * f.z, F.y * f.z};
    vw.x += F.x * w, vw.y += F.y * w, vw.z += F.z * w;
    ww += {W.x * w.x, W.y * w.y, W.z * w.z, W.x * w.y, W.x * w.z, W.y * w.z};
  }
};

/// Huber's k. The 2-D distance of a good match exceeds 3 once in 90 (Rayleigh).
template <class S>
inline constexpr S kHuberDistance{3};

/// How well marks fit.
template <class S>
struct Misfit {
  S chi2{};    ///< sum of squared 2-D distances, in standard deviations
  S excess{};  ///< what Huber's loss takes off the half of it
  S error2{};  ///< ||e||^2, metric image plane
  S cost() const noexcept { return S(0.5) * chi2 - excess; }

  /// Counts a mark's squared distance and returns its certainty times its robust weight.
  S weigh(S distance2, S certainty) noexcept {
    error2 += distance2;
    const S normalised2 = distance2 * certainty;
    chi2 += normalised2;
    if (normalised2 <= kHuberDistance<S> * kHuberDistance<S>) return certainty;
    excess += S(0.5) * normalised2 - math::huber_loss(normalised2, kHuberDistance<S>);
    return certainty * math::huber_weight(normalised2, kHuberDistance<S>);
  }
};

/// Adds what the centres of the imaged circles of a plate say, for those that are matched. With c a circle's centre in
/// {cam}, n its normal and r its radius (vision::imaged_centre has the source of M):
///
///     M = c c_z + r^2 (n n_z - e3),   s = (M_x, M_y) / M_z,   e = s - s_star
///     ds_x = b (v_x + h_x v_z + k (omega x n)_x + k_x (omega x n)_z),   v the velocity of c; likewise y
///     b = c_z / M_z,   h_x = c_x / c_z - 2 s_x,   k = r^2 n_z / c_z,   k_x = r^2 n_x / c_z - 2 s_x k
///
/// so that omega has the coefficients  b (arm x (1, 0, h_x) + n x (k, 0, k_x))  in s_x. The factor b goes with the
/// weight. Arms are taken from the turning point and not from {cam}'s origin: seen from far away the difference between
/// turning and sliding would be one of large numbers.
///
/// t: the turning point in {cam}, m.  Work  145 multiplications and additions and 3 divisions a mark.
/// Errors  behind_camera when a part of a circle's neighbourhood reaches the plane Z = 0, or on NaN.
template <class S>
Status add_centres(const PlacedMark<S>* marks, std::size_t num_marks, const math::Triple<S>& n, S r,
                   const math::Triple<S>& t, BodyInformation<S>& body, Misfit<S>& misfit) noexcept {
  using T = math::Triple<S>;
  const T rn = (r * r) * n, N{rn.x * n.z, rn.y * n.z, rn.z * n.z - r * r};
  const S nearest = r > S(vision::kMinDepth_m) ? r : S(vision::kMinDepth_m);
  for (const PlacedMark<S>* mark = marks; mark != marks + num_marks; ++mark) {
    const Match<S>& match = *mark->match;
    if (!match.matched || !(match.variance > S(0))) continue;
    const T arm = mark->arm;
    const T c = t + arm;
    if (!(c.z > nearest)) return Status::behind_camera;
    const S scale = S(1) / (c.z * c.z + N.z), near = S(1) / c.z;
    const S s_x = (c.x * c.z + N.x) * scale, s_y = (c.y * c.z + N.y) * scale;
    const S d_x = match.s_star[0] - s_x, d_y = match.s_star[1] - s_y;
    const S b = c.z * scale;
    const S weight_b = misfit.weigh(d_x * d_x + d_y * d_y, S(1) / match.variance) * b;
    const S weight = weight_b * b;  // of rows divided by b

    const S h_x = c.x * near - S(2) * s_x, h_y = c.y * near - S(2) * s_y;
    const S k = rn.z * near, k_x = rn.x * near - S(2) * s_x * k, k_y = rn.y * near - S(2) * s_y * k;
    const T p = arm + k * n;
    const T w_x{arm.y * h_x + n.y * k_x, p.z - (arm.x * h_x + n.x * k_x), -p.y};
    const T w_y{arm.y * h_y + n.y * k_y - p.z, -(arm.x * h_y + n.x * k_y), p.x};
    const T W_x = weight * w_x, W_y = weight * w_y;
    const S H_x = weight * h_x, H_y = weight * h_y;
    body.vv.xx += weight, body.vv.yy += weight, body.vv.zz += H_x * h_x + H_y * h_y;
    body.vv.xz += H_x, body.vv.yz += H_y;
    body.vw.x += W_x, body.vw.y += W_y, body.vw.z += h_x * W_x + h_y * W_y;
    body.ww.xx += W_x.x * w_x.x + W_y.x * w_y.x, body.ww.yy += W_x.y * w_x.y + W_y.y * w_y.y;
    body.ww.zz += W_x.z * w_x.z + W_y.z * w_y.z, body.ww.xy += W_x.x * w_x.y + W_y.x * w_y.y;
    body.ww.xz += W_x.x * w_x.z + W_y.x * w_y.z, body.ww.yz += W_x.y * w_x.z + W_y.y * w_y.z;
    const S pull_x = weight_b * d_x, pull_y = weight_b * d_y;
    body.pull.force += T{pull_x, pull_y, pull_x * h_x + pull_y * h_y};
    body.pull.torque += pull_x * w_x + pull_y * w_y;
  }
  return Status::ok;
}

/// H times the twist of a joint's unit rate: what the joint has in common with everything that moves the body.
template <class S>
[[gnu::always_inline]] inline Wrench<S> of_slide(const BodyInformation<S>& body,
                                                 const math::Triple<S>& linear) noexcept {
  return {body.vv * linear, linear.x * body.vw.x + linear.y * body.vw.y + linear.z * body.vw.z};
}
template <class S>
[[gnu::noinline]] Wrench<S> of_turn(const BodyInformation<S>& body, const math::Triple<S>& linear,
                                    const math::Triple<S>& angular) noexcept {
  const auto& [x, y, z] = body.vw;
  const Wrench<S> slide = of_slide(body, linear);
  return {slide.force + math::Triple<S>{dot(x, angular), dot(y, angular), dot(z, angular)},
          slide.torque + body.ww * angular};
}

}  // namespace articam::tracker
