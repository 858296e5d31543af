#pragma once
/// @file  What a user may choose of the tracker, with the reason for each default.

#include <cstdint>

namespace articam::tracker {

enum class Mode : std::uint8_t {
  standard,  ///< iterated to convergence inside the frame; `--mode default`
  paper,     ///< one step of (5) and (6) a frame, to the letter; the baseline to beat
};

/// lambda(||e||) = (l0 - linf) exp(-slope ||e|| / (l0 - linf)) + linf: high when the error is low.
/// The paper gives the two gains (section V); the form and the slope are ours. With slope 60, an error of 0.035 on
/// the metric plane (18 px at f = 525) is half way between them.
struct GainProfile {
  double at_zero{5};      ///< l0, 1/s
  double at_infinity{2};  ///< linf, 1/s
  double slope{60};       ///< -d lambda / d||e|| at zero error, 1/s
};

/// A number for each sort of degree of freedom: of the base, and of joints that slide and that turn.
struct PerFreedom {
  double base_m, base_rad, slide_m, turn_rad;
};

struct Options {
  Mode mode{Mode::standard};
  GainProfile gain{};
  bool feed_forward{false};          ///< s_star_dot of (5); the paper switches it off as too noisy
  double feed_forward_time_s{0.05};  ///< time constant of its low pass, first order

  double floor_px{0.001};    ///< added to each detection's noise: the errors that stay; of what is beyond, frames teach
  double max_rms_px{1.5};    ///< a larger residual is no estimate
  double coast_time_s{0.5};  ///< a prediction is worth this long; then lost
  double max_gap_s{1.0};     ///< a longer gap between frames is not integrated

  /// Unknown acceleration, as the root of its spectral density (1/s^2 a root hertz): between frames of 30 Hz it moves
  /// the object by 0.7 mm and 0.2 degrees, ten times what the markers leave open, so that the estimate lags behind
  /// nothing; and a mark that leaps by a centimetre contradicts it.
  PerFreedom acceleration{0.2, 1, 0.2, 1};
  /// What is known before anything has been seen: deviation about q0, and of the rates about 0 (1/s).
  PerFreedom start{0.5, 1, 0.5, 1};
  PerFreedom start_rate{0.3, 1, 0.3, 1};
  /// A degree of freedom is observed in a frame whose marks alone tell it to half of this.
  PerFreedom coarse{0.02, 0.1, 0.02, 0.1};
};

}  // namespace articam::tracker
