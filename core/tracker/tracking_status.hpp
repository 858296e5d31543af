#pragma once
/// @file  What can be said of an estimate in one word. Needs no Eigen: receivers of the link include it too.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace articam::tracker {

enum class TrackingStatus : std::uint8_t {
  initialising,  ///< no estimate to trust yet
  tracking,      ///< every degree of freedom observed, even if a marker is missing
  degraded,      ///< some degrees of freedom weak or held, or a poor image
  coasting,      ///< nothing measured, predicted only
  lost,          ///< for longer than a prediction is worth, nothing was measured that can be trusted
  fault,         ///< the input or the model cannot be right
};

enum class Reason : std::uint8_t {
  none,
  no_start,        ///< neither a compiled-in q0 nor one given
  no_frame,        ///< the camera gave nothing in time
  stale_frame,     ///< the frame is not later than the one before
  image_mismatch,  ///< the frame's size is not the camera file's
  few_markers,     ///< fewer matches than the unknowns need
  not_converged,   ///< the iterations still move
  large_residual,  ///< converged, but the features do not fit the model
  outlier,         ///< a match was left out because it contradicts the others
  weak_joint,      ///< a degree of freedom is held by its prior
  overload,        ///< the frame exceeded the detector's capacities
  camera_stalled,  ///< no frame for several periods
  camera_gone,     ///< the camera was unplugged, or cannot be opened
  late_result,     ///< good, but out later than its age allows
  ambiguous,       ///< two configurations explain the frame, and no start decides
  joint_limit,     ///< a joint is held at its limit, and the marks want it farther
  overexposed,     ///< the image is too bright: most marks are saturated, or some missing and a quarter of it white
  underexposed,    ///< the image is too dark
  blurred,         ///< the image is blurred
};

constexpr std::string_view name(TrackingStatus status) noexcept {
  constexpr std::string_view kNames[]{"initialising", "tracking", "degraded", "coasting", "lost", "fault"};
  return kNames[static_cast<std::size_t>(status)];
}
constexpr std::string_view name(Reason reason) noexcept {
  constexpr std::string_view kNames[]{
      "none",           "no_start",    "no_frame",    "stale_frame",  "image_mismatch", "few_markers", "not_converged",
      "large_residual", "outlier",     "weak_joint",  "overload",     "camera_stalled", "camera_gone", "late_result",
      "ambiguous",      "joint_limit", "overexposed", "underexposed", "blurred"};
  return kNames[static_cast<std::size_t>(reason)];
}

/// What the newest frame has said of one degree of freedom.
enum class Observability : std::uint8_t {
  held,  ///< nothing: its value is the prediction's
  weak,  ///< less than was known without it
  observed,
};

}  // namespace articam::tracker
