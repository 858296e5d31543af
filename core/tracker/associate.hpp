#pragma once
/// @file  Detections -> matches: which mark is which marker.

#include <array>
#include <cmath>

#include "core/math/assignment.hpp"
#include "core/tracker/innovation.hpp"
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

/// What a marker costs that stays alone, in units of -2 ln of a likelihood: it was missed, 1 in 20, and the mark that
/// it leaves is clutter, one a frame of 640 x 480, against the density of a match of a known configuration.
template <class S>
inline constexpr S kAlone = S(24);

/// The most likely one-to-one pairing of visible features and detections inside their gates; what has no partner stays
/// unmatched.
template <class M, class S>
Matches<M, S> associate(const Features<M, S>& features, const vision::Detections& detections,
                        const vision::CameraModel<S>& camera, S floor_px) noexcept {
  constexpr std::size_t kRows = static_cast<std::size_t>(model::kNumMarkers<M>);
  const auto cost = [&](std::size_t f, std::size_t d) -> S {
    constexpr S kForbidden = std::numeric_limits<S>::infinity();
    if (!features[f].visible) return kForbidden;
    const auto found = innovation(features[f], detections[d]);
    return found.passes() ? found.centre + found.size + found.width : kForbidden;
  };
  const auto partner = math::assign<kRows, kMaxDetections>(kRows, detections.size(), kAlone<S>, cost);

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
    const vision::Ellipse& mark = detections[d].outer;
    matches[f] = {true,
                  partner[f],
                  {S(vision::from_q16(mark.u_q16)), S(vision::from_q16(mark.v_q16))},
                  s_star,
                  (variance_px2 + floor_px * floor_px) / seen.value().J.determinant()};  // px^2 to the metric plane
  }
  return matches;
}

}  // namespace articam::tracker
