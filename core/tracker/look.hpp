#pragma once
/// @file  Where to look for marks while following: where they are expected, around that, and everywhere.

#include <span>

#include "core/tracker/associate.hpp"
#include "core/vision/detector.hpp"

namespace articam::tracker {

/// Columns and rows that a feature may be found in, its whole image and a border of background included.
template <class S>
PixelBox window_of(const Feature<S>& feature) noexcept {
  const Vec<S, 2> reach = reach_px(feature) + Vec<S, 2>::Constant(S(1.3) * feature.radius_px + S(3));
  const auto edge = [](S centre, S away) {
    constexpr S kFar{1e6};  // beyond any image, within any int
    const S x = centre + away;
    return static_cast<int>(x < -kFar ? -kFar : (x > kFar ? kFar : x));
  };
  return {edge(feature.pixel.x(), -reach.x()), edge(feature.pixel.y(), -reach.y()), edge(feature.pixel.x(), reach.x()),
          edge(feature.pixel.y(), reach.y())};
}

/// Some mark of the feature's kind lies where the feature is expected, to half a radius.
template <class S>
bool is_seen(const Feature<S>& feature, const vision::Detections& marks) noexcept {
  for (const vision::Detection& mark : marks) {
    const Vec<S, 2> centre{S(vision::from_q16(mark.outer.u_q16)), S(vision::from_q16(mark.outer.v_q16))};
    const S reach = S(0.5) * feature.radius_px;
    if (mark.kind == feature.kind && (centre - feature.pixel).squaredNorm() < reach * reach) return true;
  }
  return false;
}

/// Image, predicted features -> detections. Each visible feature is measured where it is expected; windows are searched
/// for those that are not there; the whole frame, where more than half are still missing.
/// Returns whether the detector was overloaded. The image has been checked: the detector does not refuse it.
template <class M, class S>
bool look(vision::Detector& detector, const ImageView& image, const Features<M, S>& features,
          vision::Detections& out) noexcept {
  constexpr auto kMarkers = static_cast<std::size_t>(model::kNumMarkers<M>);
  FixedVector<vision::Expected, kMarkers> expected;
  int visible = 0;
  for (const Feature<S>& feature : features) {
    visible += feature.visible ? 1 : 0;
    if (feature.visible) (void)expected.push_back({feature.kind, feature.image});
  }
  (void)detector.measure(image, {expected.begin(), expected.size()}, out);

  FixedVector<PixelBox, kMarkers> windows;
  for (const Feature<S>& feature : features) {
    if (feature.visible && !is_seen(feature, out)) (void)windows.push_back(window_of(feature));
  }
  bool overloaded = false;
  if (!windows.empty()) {
    (void)detector.detect_more(image, {windows.begin(), windows.size()}, out);
    overloaded = detector.overloaded();
  }
  if (2 * static_cast<int>(out.size()) < visible) {
    (void)detector.detect(image, out);
    overloaded = detector.overloaded();
  }
  return overloaded;
}

}  // namespace articam::tracker
