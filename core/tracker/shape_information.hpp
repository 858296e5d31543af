#pragma once
/// @file  What the size and shape of a mark's image say about how its body has to move.
///
/// Three more equations for each mark: M of its imaged ellipse, in the metric plane (imaged_ellipse.hpp). They tell how
/// far away and how tilted each mark is, so that one mark alone, or a drawer seen along its axis, still inform a joint.
///
/// All marks come from one printer, which may have scaled them. The common factor 1 + u of their radii is a nuisance: u
/// has the deviation kPrintScale and is solved for in every frame anew, so that nothing is built upon a size that the
/// marks of one frame do not confirm.

#include "core/tracker/body_information.hpp"
#include "core/vision/moving_shape.hpp"

namespace articam::tracker {

/// Of the logarithm of the marks' common scale. Printers stretch paper by a few tenths of a percent.
template <class S>
inline constexpr S kPrintScale{S(0.005)};

/// The normal equations' part of ln(1 + u):  its information and pull; what it has in common with a body is in the
/// body's BodyInformation::scale.
template <class S>
struct ScaleInformation {
  S information{}, pull{};
};

/// Adds what an imaged centre, which lies off the circle's by r^2, says of u:  g = -2 b alpha. `certainty`: its own,
/// times its robust weight.
template <class S>
[[gnu::always_inline]] inline void add_scale_of(const MovingCentre<S>& centre, const vision::ConicCentre<S>& conic,
                                                const Match<S>& match, S certainty, Wrench<S>& common,
                                                ScaleInformation<S>& scale) noexcept {
  const S twice_b = S(-2) * centre.b, g_x = twice_b * conic.alpha_x, g_y = twice_b * conic.alpha_y;
  const S with_x = certainty * g_x, with_y = certainty * g_y;
  scale.information += with_x * g_x + with_y * g_y;
  scale.pull += with_x * (match.s_star[0] - centre.s_x) + with_y * (match.s_star[1] - centre.s_y);
  const S b_x = with_x * centre.b, b_y = with_y * centre.b;
  common.force += math::Triple<S>{b_x, b_y, b_x * centre.h_x + b_y * centre.h_y};
  common.torque += b_x * centre.w_x + b_y * centre.w_y;
}

/// Adds (m00, m10, m11) of one imaged circle. With f the rows of v:
///
///     dM = f v + w omega + g u,    g = -f c
///
/// as a scene and its scaled image look alike.  n_t: n x t.
template <class S>
[[gnu::always_inline]] inline void add_shape(vision::MovingShape<S>& shape, const vision::Plate<S>& plate,
                                             const math::Triple<S>& c, const math::Triple<S>& n_t,
                                             const PlacedMark<S>& mark, BodyInformation<S>& body, Misfit<S>& misfit,
                                             ScaleInformation<S>& scale) noexcept {
  using T = math::Triple<S>;
  const Match<S>& match = *mark.match;
  const T miss{match.shape[0] - shape.m00, match.shape[1] - shape.m10, match.shape[2] - shape.m11};
  const S factor = std::sqrt(misfit.weigh(dot(miss, miss), S(1) / match.shape_variance));
  shape.move(plate, c, mark.arm, n_t, factor);  // all rows times the root of their weight
  const auto& [f_x, f_y, f_z] = shape.f;
  const auto& [w_x, w_y, w_z] = shape.w;
  const T d = factor * miss;
  const T g{-(c.x * f_x.x + c.z * f_z.x), -(c.x * f_x.y + c.y * f_y.y + c.z * f_z.y),
            -(c.x * f_x.z + c.y * f_y.z + c.z * f_z.z)};
  scale.information += dot(g, g), scale.pull += dot(d, g);
  S* entry = body.H.entries.data();
  // A row of H from the diagonal to the first column.
  const auto add = [&](S& pull, S& common, const auto& row, const auto&... columns) {
    ((*entry++ += dot(row, columns)), ...);
    pull += dot(d, row), common += dot(g, row);
  };
  auto& [force, torque] = body.pull;
  auto& [common_force, common_torque] = body.scale;
  add(force.x, common_force.x, f_x, f_x);
  add(force.y, common_force.y, f_y, f_y, f_x);
  add(force.z, common_force.z, f_z, f_z, f_y, f_x);
  add(torque.x, common_torque.x, w_x, w_x, f_z, f_y, f_x);
  add(torque.y, common_torque.y, w_y, w_y, w_x, f_z, f_y, f_x);
  add(torque.z, common_torque.z, w_z, w_z, w_y, w_x, f_z, f_y, f_x);
}

/// add_centres() and, of the marks that have one, the shapes. Edge on there is none, and it says nothing.
template <class S>
Status add_whole_marks(const PlacedMark<S>* marks, std::size_t num_marks, const vision::Plate<S>& plate,
                       const Vec<S, 3>& t, BodyInformation<S>& body, Misfit<S>& misfit, Misfit<S>& shape_misfit,
                       ScaleInformation<S>& scale) noexcept {
  const math::Triple<S> n_t = cross(plate.n, math::to_triple(t));
  for (const PlacedMark<S>* mark = marks; mark != marks + num_marks; ++mark) {
    const Match<S>& match = *mark->match;
    if (!match.matched || !(match.variance > S(0))) continue;
    const math::Triple<S> arm = mark->arm, c = math::to_triple(t) + arm;
    if (!(c.z > plate.nearest)) return Status::behind_camera;
    const MovingCentre<S> centre{plate, c, arm};
    const S certainty = add_centre(centre, match, body, misfit);
    if (!(match.shape_variance > S(0))) continue;
    const vision::ConicCentre<S> conic{plate, c, centre.s_x, centre.s_y, centre.per_M_z};
    add_scale_of(centre, conic, match, certainty, body.scale, scale);
    vision::MovingShape<S> shape{plate, c, conic};
    if (shape.exists()) add_shape(shape, plate, c, n_t, *mark, body, shape_misfit, scale);
  }
  return Status::ok;
}

}  // namespace articam::tracker
