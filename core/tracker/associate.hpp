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
  Vec<S, 3> shape{Vec<S, 3>::Zero()};   ///< m00, m10, m11 of the ellipse on the metric plane
  S shape_variance{};                   ///< of each of them; 0 where the shape is not to be used
};

template <class M, class S>
using Matches = std::array<Match<S>, static_cast<std::size_t>(model::kNumMarkers<M>)>;

template <class M, class S>
int count(const Matches<M, S>& matches) noexcept {
  int n = 0;
  for (const auto& match : matches) n += match.matched ? 1 : 0;
  return n;
}

/// Of centres and shapes.
template <class M, class S>
int num_equations(const Matches<M, S>& matches) noexcept {
  int n = 0;
  for (const auto& match : matches) n += match.matched ? (match.shape_variance > S(0) ? 5 : 2) : 0;
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
    const vision::Detection& mark = detections[d];
    const Mat<S, 2, 2>& shape = on_plane.value().M;
    const S per_px2 = S(1) / seen.value().J.determinant();  // px^2 to the metric plane
    const auto variance = [&](std::uint32_t of_detection_q24) {
      return (static_cast<S>(of_detection_q24) / S(1 << 24) + floor_px * floor_px) * per_px2;
    };
    matches[f] = {true,
                  partner[f],
                  {S(vision::from_q16(mark.outer.u_q16)), S(vision::from_q16(mark.outer.v_q16))},
                  s_star,
                  variance(mark.centre_variance_q24),
                  {shape(0, 0), shape(1, 0), shape(1, 1)},
                  mark.flaws == 0 && mark.axis_variance_q24 > 0 ? variance(mark.axis_variance_q24) : S(0)};
  }
  return matches;
}

}  // namespace articam::tracker
