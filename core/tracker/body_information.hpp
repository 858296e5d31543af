#pragma once
/// @file  What the marks on a body say about how the body has to move.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/math/robust_weights.hpp"
#include "core/math/tree_factor.hpp"
#include "core/math/triple.hpp"
#include "core/tracker/associate.hpp"
#include "core/vision/plate.hpp"

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
/// Shapes  H 6x6, first v, then omega.  Frames  along the axes of {cam}.
/// Units   m, rad and the metric image plane, divided by the marks' variances.
template <class S>
struct BodyInformation {
  math::TreeMatrix<math::Chain<6>, S> H{};
  Wrench<S> pull{};   ///< -A^T w e
  Wrench<S> scale{};  ///< what the twist has in common with the marks' scale; see shape_information.hpp

  BodyInformation() noexcept {}  // member by member: a whole of this size would be cleared by a loop

  BodyInformation& operator+=(const BodyInformation& b) noexcept {
    for (std::size_t i = 0; i < H.entries.size(); ++i) H.entries[i] += b.H.entries[i];
    pull += b.pull, scale += b.scale;
    return *this;
  }
  /// The 3x3 block that begins there, times v.
  template <int kRow, int kColumn>
  [[gnu::always_inline]] math::Triple<S> block_times(const math::Triple<S>& v) const noexcept {
    return {row_times<kRow, kColumn>(v), row_times<kRow + 1, kColumn>(v), row_times<kRow + 2, kColumn>(v)};
  }

 private:
  template <int kRow, int kColumn>
  [[gnu::always_inline]] S row_times(const math::Triple<S>& v) const noexcept {
    return entry<kRow, kColumn>() * v.x + entry<kRow, kColumn + 1>() * v.y + entry<kRow, kColumn + 2>() * v.z;
  }
  template <int kRow, int kColumn>
  [[gnu::always_inline]] S entry() const noexcept {
    constexpr int kIndex = math::TreePattern<math::Chain<6>>::entry(std::max(kRow, kColumn), std::min(kRow, kColumn));
    return H.entries[kIndex];
  }
};

/// Huber's k. The 2-D distance of a good match exceeds 3 once in 90 (Rayleigh).
template <class S>
inline constexpr S kHuberDistance{3};

/// How well marks fit.
template <class S>
struct Misfit {
  S chi2{};    ///< sum of squared 2-D distances, in standard deviations
  S excess{};  ///< what twice Huber's loss lacks of it
  S error2{};  ///< ||e||^2, metric image plane
  S cost() const noexcept { return S(0.5) * (chi2 - excess); }

  /// Counts a mark's squared distance and returns its certainty times its robust weight.
  S weigh(S distance2, S certainty) noexcept {
    error2 += distance2;
    const S normalised2 = distance2 * certainty;
    chi2 += normalised2;
    if (normalised2 <= kHuberDistance<S> * kHuberDistance<S>) return certainty;
    const S size = std::sqrt(normalised2);
    excess += math::huber_excess(size, kHuberDistance<S>);
    return math::huber_weight(size, kHuberDistance<S>, certainty);
  }
};

/// The imaged centre of a plate's circle and how it moves. With c the circle's centre in {cam}, n its normal and r its
/// radius (vision::imaged_centre has the source of M):
///
///     M = c c_z + r^2 (n n_z - e3),   s = (M_x, M_y) / M_z
///     ds_x = b (f_x . v + w_x . omega),   b = c_z / M_z,   f_x = (1, 0, h_x),   h_x = c_x / c_z - 2 s_x
///     w_x = p x f_x + g_x (n x e3),   p = arm + k n,   k = r^2 n_z / c_z,   g_x = (r^2 n_x - k c_x) / c_z;   likewise
///     y
///
/// Arms are taken from the turning point and not from {cam}'s origin: seen from far away the difference between turning
/// and sliding would be one of large numbers.
template <class S>
struct MovingCentre {
  S per_M_z, s_x, s_y, b, h_x, h_y;
  math::Triple<S> w_x, w_y;

  [[gnu::always_inline]] MovingCentre(const vision::Plate<S>& plate, const math::Triple<S>& c,
                                      const math::Triple<S>& arm) noexcept {
    const auto& [n, r, rn, at_pole, N_z, nearest] = plate;
    const S near = S(1) / c.z;
    per_M_z = S(1) / (c.z * c.z + N_z);
    s_x = (c.x * c.z + at_pole.x) * per_M_z, s_y = (c.y * c.z + at_pole.y) * per_M_z;
    b = c.z * per_M_z;
    const S a_x = c.x * near, a_y = c.y * near;
    h_x = a_x - s_x - s_x, h_y = a_y - s_y - s_y;
    const S g_x = near * (rn.x - a_x * rn.z), g_y = near * (rn.y - a_y * rn.z);
    const math::Triple<S> p = arm + near * at_pole;
    w_x = {p.y * h_x + g_x * n.y, p.z - (p.x * h_x + g_x * n.x), -p.y};
    w_y = {p.y * h_y + g_y * n.y - p.z, -(p.x * h_y + g_y * n.x), p.x};
  }
};

/// Adds what an imaged centre says,  e = s - s_star. The factor b of its rows goes with the weight. Returns its
/// certainty times its robust weight.
template <class S>
[[gnu::always_inline]] inline S add_centre(const MovingCentre<S>& centre, const Match<S>& match,
                                           BodyInformation<S>& body, Misfit<S>& misfit) noexcept {
  const auto& [per_M_z, s_x, s_y, b, h_x, h_y, w_x, w_y] = centre;
  const S d_x = match.s_star[0] - s_x, d_y = match.s_star[1] - s_y;
  const S certainty = misfit.weigh(d_x * d_x + d_y * d_y, S(1) / match.variance);
  const S weight_b = certainty * b, weight = weight_b * b;
  const S pull_x = weight_b * d_x, pull_y = weight_b * d_y;
  body.pull.force += math::Triple<S>{pull_x, pull_y, pull_x * h_x + pull_y * h_y};
  // Column by column, so that what is done with leaves its registers.
  auto& H = body.H;
  {
    const S x = weight * h_x, y = weight * h_y;
    H.at(2, 2) += x * h_x + y * h_y, H.at(2, 0) += x, H.at(2, 1) += y;
    H.at(0, 0) += weight, H.at(1, 1) += weight;
    H.at(3, 2) += x * w_x.x + y * w_y.x, H.at(4, 2) += x * w_x.y + y * w_y.y, H.at(5, 2) += x * w_x.z + y * w_y.z;
  }
  {
    const S x = weight * w_x.x, y = weight * w_y.x;
    body.pull.torque.x += pull_x * w_x.x + pull_y * w_y.x;
    H.at(3, 3) += x * w_x.x + y * w_y.x, H.at(4, 3) += x * w_x.y + y * w_y.y, H.at(5, 3) += x * w_x.z + y * w_y.z;
    H.at(3, 0) += x, H.at(3, 1) += y;
  }
  {
    const S x = weight * w_x.y, y = weight * w_y.y;
    body.pull.torque.y += pull_x * w_x.y + pull_y * w_y.y;
    H.at(4, 4) += x * w_x.y + y * w_y.y, H.at(5, 4) += x * w_x.z + y * w_y.z;
    H.at(4, 0) += x, H.at(4, 1) += y;
  }
  {
    const S x = weight * w_x.z, y = weight * w_y.z;
    body.pull.torque.z += pull_x * w_x.z + pull_y * w_y.z;
    H.at(5, 5) += x * w_x.z + y * w_y.z;
    H.at(5, 0) += x, H.at(5, 1) += y;
  }
  return certainty;
}

/// Adds what the centres of the imaged circles of a plate say, for those that are matched.
/// t: the turning point in {cam}, m.  Work  143 multiplications and additions and 3 divisions a mark.
/// Errors  behind_camera when a part of a circle's neighbourhood reaches the plane Z = 0, or on NaN.
template <class S>
Status add_centres(const PlacedMark<S>* marks, std::size_t num_marks, const vision::Plate<S>& plate, const Vec<S, 3>& t,
                   BodyInformation<S>& body, Misfit<S>& misfit) noexcept {
  for (const PlacedMark<S>* mark = marks; mark != marks + num_marks; ++mark) {
    const Match<S>& match = *mark->match;
    if (!match.matched || !(match.variance > S(0))) continue;
    const math::Triple<S> arm = mark->arm, c = math::to_triple(t) + arm;
    if (!(c.z > plate.nearest)) return Status::behind_camera;
    add_centre(MovingCentre<S>{plate, c, arm}, match, body, misfit);
  }
  return Status::ok;
}

/// H times the twist of a joint's unit rate: what the joint has in common with everything that moves the body.
template <class S>
[[gnu::always_inline]] inline Wrench<S> of_slide(const BodyInformation<S>& body,
                                                 const math::Triple<S>& linear) noexcept {
  return {body.template block_times<0, 0>(linear), body.template block_times<3, 0>(linear)};
}
template <class S>
[[gnu::noinline]] Wrench<S> of_turn(const BodyInformation<S>& body, const math::Triple<S>& linear,
                                    const math::Triple<S>& angular) noexcept {
  const Wrench<S> slide = of_slide(body, linear);
  return {slide.force + body.template block_times<0, 3>(angular),
          slide.torque + body.template block_times<3, 3>(angular)};
}

}  // namespace articam::tracker
