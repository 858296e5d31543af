#pragma once
/// @file  Detections -> matches: which mark is which marker.

#include <array>
#include <cmath>

#include "core/math/assignment.hpp"
#include "core/tracker/features.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/lens_ellipse.hpp"

namespace articam::tracker {

/// A marker and the detection that belongs to it.
template <class S>
struct Match {
  bool matched{};
  int detection{-1};                    ///< index in the frame's detections
  Vec<S, 2> pixel{Vec<S, 2>::Zero()};   ///< measured centre
  Vec<S, 2> s_star{Vec<S, 2>::Zero()};  ///< the same on the metric plane, lens distortion removed
  S variance{};                         ///< of each coordinate of s_star
};

template <class M, class S>
using Matches = std::array<Match<S>, static_cast<std::size_t>(model::kNumMarkers<M>)>;

template <class M, class S>
int count(const Matches<M, S>& matches) noexcept {
  int n = 0;
  for (const auto& match : matches) n += match.matched ? 1 : 0;
  return n;
}

/// How far a detection may be from its prediction.
template <class S>
struct Gate {
  S distance_px;  ///< centre to centre, in addition to `diameters` of the marker's image
  S diameters;
  S size_ratio;  ///< measured : predicted size, and its inverse
};
template <class S>
inline constexpr Gate<S> kTrackingGate{S(4), S(0.75), S(1.6)};
template <class S>
inline constexpr Gate<S> kSearchGate{S(160), S(0), S(2.5)};  // q0 may be far off; size tells little then

/// The farthest that a detection's centre may be from a feature's, px.
template <class S>
S reach_px(const Feature<S>& feature, const Gate<S>& gate) noexcept {
  return gate.distance_px + gate.diameters * S(2) * feature.radius_px + feature.spread_px;
}

/// The radius of the disc of the same area: the geometric mean of the semi-axes.
template <class S>
S mean_radius_px(const vision::Ellipse& e) noexcept {
  return std::sqrt(S(vision::from_q16(e.m00_q16)) * S(vision::from_q16(e.m11_q16)));
}

/// The one-to-one pairing of visible features and detections of the same kind with the least sum of squared
/// distances (px); what has no partner inside the gate stays unmatched.
template <class M, class S>
Matches<M, S> associate(const Features<M, S>& features, const vision::Detections& detections,
                        const vision::CameraModel<S>& camera, const Gate<S>& gate, S floor_px) noexcept {
  constexpr S kForbidden = std::numeric_limits<S>::infinity();
  constexpr std::size_t kRows = static_cast<std::size_t>(model::kNumMarkers<M>);
  const auto centre = [&](std::size_t d) -> Vec<S, 2> {
    return {S(vision::from_q16(detections[d].outer.u_q16)), S(vision::from_q16(detections[d].outer.v_q16))};
  };
  // Squared distance in units of the feature's own gate, so that staying alone costs 1 for each.
  const auto cost = [&](std::size_t f, std::size_t d) -> S {
    const Feature<S>& feature = features[f];
    if (!feature.visible || detections[d].kind != feature.kind) return kForbidden;
    // Tilt leaves between 1/3 and all of the minor axis: the square root of the area is 0.58 to 1 of the major axis.
    const S size = mean_radius_px<S>(detections[d].outer) / feature.radius_px;
    if (size > gate.size_ratio || size * gate.size_ratio < S(0.58)) return kForbidden;
    const S reach = reach_px(feature, gate);
    const S d2 = (centre(d) - feature.pixel).squaredNorm() / (reach * reach);
    return d2 < S(1) ? d2 : kForbidden;
  };
  const auto partner = math::assign<kRows, kMaxDetections>(kRows, detections.size(), S(1), cost);

  Matches<M, S> matches{};
  for (std::size_t f = 0; f < kRows; ++f) {
    if (partner[f] < 0) continue;
    const auto d = static_cast<std::size_t>(partner[f]);
    const auto on_plane = vision::undistorted_ellipse<S>(detections[d].outer, camera);
    if (!on_plane.ok()) continue;
    const Vec<S, 2> s_star = on_plane.value().centre;
    const auto seen = camera.project_with_slope(s_star);
    if (!seen.ok()) continue;
    const S variance_px2 = static_cast<S>(detections[d].centre_variance_q24) / S(1 << 24);
    matches[f] = {true, partner[f], centre(d), s_star,
                  (variance_px2 + floor_px * floor_px) / seen.value().J.determinant()};  // px^2 to the metric plane
  }
  return matches;
}

}  // namespace articam::tracker
