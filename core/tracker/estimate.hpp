#pragma once
/// @file  What the tracker gives out at every frame, with or without an estimate.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/model/configuration.hpp"
#include "core/model/model_table.hpp"
#include "core/timestamp.hpp"

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
};

constexpr std::string_view name(TrackingStatus status) noexcept {
  constexpr std::string_view kNames[]{"initialising", "tracking", "degraded", "coasting", "lost", "fault"};
  return kNames[static_cast<std::size_t>(status)];
}
constexpr std::string_view name(Reason reason) noexcept {
  constexpr std::string_view kNames[]{
      "none",           "no_start", "no_frame",   "stale_frame", "image_mismatch", "few_markers", "not_converged",
      "large_residual", "outlier",  "weak_joint", "overload",    "camera_stalled", "camera_gone", "late_result"};
  return kNames[static_cast<std::size_t>(reason)];
}

/// What the newest frame has said of one degree of freedom.
enum class Observability : std::uint8_t {
  held,  ///< nothing: its value is the prediction's
  weak,  ///< less than was known without it
  observed,
};

/// Shapes  covariance and velocity are of size nv = 6 + n, ordered (t, rotation, joints).
/// Frames  pose of {obj} in {cam}; velocity and covariance of t and rotation are written in {cam},
///         the rotation as R = exp(delta) R_est.
/// Units   m, rad, s.
template <class Model, class S>
struct Estimate {
  static constexpr int kDof = model::kDof<Model>;

  std::uint32_t frame{};  ///< of the last frame taken, counted from 0, dropped ones included
  Timestamp t_capture{};  ///< mid-exposure
  TrackingStatus status{TrackingStatus::initialising};
  Reason reason{Reason::none};
  bool valid{};  ///< q, qdot and covariance mean something; in paper mode from the first step on
  model::Configuration<Model, S> q{};
  Vec<S, kDof> qdot{Vec<S, kDof>::Zero()};
  Mat<S, kDof, kDof> covariance{Mat<S, kDof, kDof>::Zero()};
  std::array<Observability, static_cast<std::size_t>(kDof)> observability{};  ///< of the frame; all held without one
  int matched{};   ///< features matched, outliers not counted
  S rms_px{};      ///< root mean square of the 2-D distances of matched features
  S error_norm{};  ///< ||e|| before the first step, metric image plane (paper, figure 3)
  int iterations{};
};

}  // namespace articam::tracker
