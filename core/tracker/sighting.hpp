#pragma once
/// @file  Detections -> sightings: what acquisition needs of each mark, worked out once a frame.

#include <cstdint>

#include "core/tracker/associate.hpp"
#include "core/vision/circle_poses.hpp"

namespace articam::tracker {

/// The second moments of an ellipse on the metric plane: M M^T as (xx, xy, yy).
template <class S>
using Shape = Vec<S, 3>;

/// sum of (lambda_i - 1)^2 over the eigenvalues of P^-1 Q: how far the shape Q is from P, in relative squared axes,
/// the same in any coordinates of the plane.
template <class S>
S shape_distance2(const Shape<S>& P, const Shape<S>& Q) noexcept {
  const S det_P = P[0] * P[2] - P[1] * P[1];
  if (!(det_P > S(0))) return std::numeric_limits<S>::infinity();
  const S trace = (P[2] * Q[0] - S(2) * P[1] * Q[1] + P[0] * Q[2]) / det_P;
  const S det = (Q[0] * Q[2] - Q[1] * Q[1]) / det_P;
  return trace * trace - S(2) * det - S(2) * trace + S(2);
}

/// A mark that was seen, freed of the lens.
template <class S>
struct Sighting {
  int detection{-1};  ///< index in the frame's detections
  vision::MarkKind kind{};
  Vec<S, 2> pixel{Vec<S, 2>::Zero()};
  Vec<S, 2> s_star{Vec<S, 2>::Zero()};  ///< centre on the metric plane
  S variance{};                         ///< of each of its coordinates
  Shape<S> shape{Shape<S>::Zero()};
  S shape_variance{};                              ///< of the squared axes, relative
  S range_error{};                                 ///< of the distance, relative, about three deviations
  std::array<vision::Circle<S>, 2> unit_circle{};  ///< both poses, were the mark's radius 1 m
};

/// More marks than these are clutter for certain, or for want of memory.
template <class M>
inline constexpr std::size_t kMaxSightings = 2 * model::kNumMarkers<M> + 8 < static_cast<int>(kMaxDetections)
                                                 ? static_cast<std::size_t>(2 * model::kNumMarkers<M> + 8)
                                                 : kMaxDetections;

template <class M, class S>
using Sightings = FixedVector<Sighting<S>, kMaxSightings<M>>;

/// Relative deviation of an ellipse's axis: 1 %, and a tenth of a pixel of its smaller one. The edges' fit is several
/// times better in a sharp image; blur and uneven light are not in the detector's variance.
template <class S>
S axis_error(S minor_px) noexcept {
  return S(0.01) + S(0.1) / minor_px;
}

/// Errors  bad_argument, behind_camera or outside_domain: a mark of which no pose can be told.
template <class S>
Result<Sighting<S>> sight(const vision::Detection& mark, int index, const vision::CameraModel<S>& camera,
                          S floor_px) noexcept {
  const auto ellipse = vision::undistorted_ellipse(mark.outer, camera);
  if (!ellipse.ok()) return ellipse.status();
  const auto poses = vision::circle_poses(ellipse.value(), S(1));
  if (!poses.ok()) return poses.status();
  const auto& [centre, m] = ellipse.value();
  const S focal_px = camera.focal_px();
  const S minor_px = focal_px * m(0, 0) * m(1, 1) / vision::semi_major(ellipse.value());
  const S error = axis_error(minor_px);

  Sighting<S> seen;
  seen.detection = index;
  seen.kind = mark.kind;
  seen.pixel = {S(vision::from_q16(mark.outer.u_q16)), S(vision::from_q16(mark.outer.v_q16))};
  seen.s_star = centre;
  seen.variance = (static_cast<S>(mark.centre_variance_q24) / S(1 << 24) + floor_px * floor_px) / (focal_px * focal_px);
  seen.shape = {m(0, 0) * m(0, 0), m(0, 0) * m(1, 0), m(1, 0) * m(1, 0) + m(1, 1) * m(1, 1)};
  seen.shape_variance = S(4) * error * error;
  seen.range_error = S(3) * axis_error(focal_px * vision::semi_major(ellipse.value()));
  seen.unit_circle = poses.value().solutions;
  return seen;
}

/// The radius of the disc of the same area: the geometric mean of the semi-axes.
template <class S>
S mean_radius_px(const vision::Ellipse& e) noexcept {
  return std::sqrt(S(vision::from_q16(e.m00_q16)) * S(vision::from_q16(e.m11_q16)));
}

/// The sightings of a frame, the largest first: their poses are the surest, and clutter is mostly small.
template <class M, class S>
Sightings<M, S> gather(const vision::Detections& detections, const vision::CameraModel<S>& camera,
                       S floor_px) noexcept {
  std::array<std::uint8_t, kMaxDetections> order{};
  for (std::size_t d = 0; d < detections.size(); ++d) {
    std::size_t place = d;
    const S radius = mean_radius_px<S>(detections[d].outer);
    for (; place > 0 && mean_radius_px<S>(detections[order[place - 1]].outer) < radius; --place) {
      order[place] = order[place - 1];
    }
    order[place] = static_cast<std::uint8_t>(d);
  }
  Sightings<M, S> sightings;
  for (std::size_t i = 0; i < detections.size() && !sightings.full(); ++i) {
    const auto seen = sight<S>(detections[order[i]], order[i], camera, floor_px);
    if (seen.ok()) (void)sightings.push_back(seen.value());
  }
  return sightings;
}

}  // namespace articam::tracker
