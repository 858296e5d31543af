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
#include "core/vision/imaged_ellipse.hpp"

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

/// Adds (m00, m10, m11) of one imaged circle. With D_c, D_n its derivatives by centre and normal (the rows of the
/// camera's interaction matrix are  L_v = -D_c,  L_w = -(c x D_c + n x D_n)):
///
///     dM = D_c (v + omega x arm) + D_n (omega x n) + g u,    g = -D_c c
///
/// as a scene and its scaled image look alike. The same holds of the imaged centre, which lies off the circle's by
/// r^2: add_centres() has what it says of the body, and here is what it says of u. `arm` is the circle's centre from
/// the turning point.  Errors  those of moving_ellipse(); nothing is then added.
template <class S>
Status add_shape(const vision::Circle<S>& circle, const math::Triple<S>& arm, const Match<S>& match,
                 BodyInformation<S>& body, Misfit<S>& misfit, ScaleInformation<S>& scale) noexcept {
  using T = math::Triple<S>;
  const auto image = vision::moving_ellipse(circle);
  if (!image.ok()) return image.status();
  const auto& [ellipse, L] = image.value();
  const T c = math::to_triple(circle.centre), t = c - arm;
  const std::array<S, 3> d{match.shape[0] - ellipse.M(0, 0), match.shape[1] - ellipse.M(1, 0),
                           match.shape[2] - ellipse.M(1, 1)};
  const Vec<S, 2> e = match.s_star - ellipse.centre;
  const S weight = misfit.weigh(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], S(1) / match.shape_variance);
  const S centre_weight = math::huber_weight(e.squaredNorm() / match.variance, kHuberDistance<S>) / match.variance;
  for (int i = 0; i < 5; ++i) {
    const T f{-L(i, 0), -L(i, 1), -L(i, 2)};
    const T w = -T{L(i, 3), L(i, 4), L(i, 5)} - cross(t, f);
    const bool of_centre = i < 2;
    const S g = -dot(f, c), row_weight = of_centre ? centre_weight : weight;
    const S pull = row_weight * (of_centre ? e[i] : d[static_cast<std::size_t>(i - 2)]);
    if (!of_centre) {
      body.add_row(f, w, row_weight);
      body.pull += {pull * f, pull * w};
    }
    body.scale += {row_weight * g * f, row_weight * g * w};
    scale.information += row_weight * g * g;
    scale.pull += pull * g;
  }
  return Status::ok;
}

}  // namespace articam::tracker
