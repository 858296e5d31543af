#pragma once
/// @file  Fingers without encoders: what a hand and a handle do to each other.

#include "host_sim/dynamics/mechanism.hpp"

namespace articam::sim {

/// Along each axis of the handle: play, then a spring, then a force at which the fingers slip. Units  SI.
struct FingerOptions {
  Vec<double, 3> play_m{0.0015, 0.0015, 0.0015};   ///< from one side to the other
  double stiffness = 12000, damping = 60;          ///< N/m, N s/m
  double slip_force = 40;                          ///< N
  double turn_stiffness = 40, turn_damping = 0.4;  ///< N m/rad, N m s/rad
};

/// The hand beside the handle, all in the handle's frame.
struct HandAtHandle {
  Vec<double, 3> offset_m, turn_rad;  ///< of the hand from where it took hold
  Vec6 rate;                          ///< of both
};

class Fingers {
 public:
  explicit Fingers(const FingerOptions& options) : options_{options} {}

  /// Force and moment of the hand on the handle, in the handle's frame; lets the fingers slip.
  Vec6 force(const HandAtHandle& hand) noexcept;

  /// How far they have slipped along each axis, m.
  const Vec<double, 3>& slipped_m() const noexcept { return slipped_m_; }

 private:
  FingerOptions options_;
  Vec<double, 3> slipped_m_{Vec<double, 3>::Zero()};
};

}  // namespace articam::sim
