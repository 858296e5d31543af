#pragma once
/// @file  What the tracker gives out at every frame, with or without an estimate.

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/model/configuration.hpp"
#include "core/model/model_table.hpp"
#include "core/timestamp.hpp"
#include "core/tracker/tracking_status.hpp"

namespace articam::tracker {

/// Shapes  covariance and velocity are of size nv = 6 + n, ordered (t, rotation, joints).
/// Frames  pose of {obj} in {cam}; velocity and covariance of t and rotation are written in {cam},
///         the rotation as R = exp(delta) R_est.
/// Units   m, rad, s.
template <class Model, class S>
struct Estimate {
  static constexpr int kDof = model::kDof<Model>;

  std::uint32_t frame{};  ///< of the last frame taken, counted from 0, dropped ones included
  Timestamp t_capture{};  ///< mid-exposure of the first row of the frame that it was made from
  Timestamp t{};          ///< what it holds for: t_capture, or later where it is predicted; the difference is its age
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
