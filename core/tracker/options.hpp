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

struct Options {
  Mode mode{Mode::standard};
  GainProfile gain{};
  bool feed_forward{false};  ///< s_star_dot of (5); the paper switches it off as too noisy

  double floor_px{0.005};    ///< least standard deviation of a detection; what the model misses beyond it, frames teach
  double max_rms_px{1.5};    ///< a larger residual is no estimate
  double coast_time_s{0.5};  ///< a prediction is worth this long; then lost
  double max_gap_s{1.0};     ///< a longer gap between frames is not integrated

  /// Standard deviation of the prior around the predicted configuration: wide beside what the markers say (tenths of a
  /// millimetre), so that it holds what they do not observe without holding back what they do.
  double prior_base_m{0.02}, prior_base_rad{0.1};
  double prior_slide_m{0.02}, prior_turn_rad{0.1};
  /// How fast the prior widens while a degree of freedom is not observed, per second.
  double growth_base_m{0.3}, growth_base_rad{1.0};
  double growth_slide_m{0.3}, growth_turn_rad{1.0};
  /// The prior around q0, before anything has been seen.
  double start_base_m{0.5}, start_base_rad{1.0};
  double start_slide_m{0.5}, start_turn_rad{1.0};
};

}  // namespace articam::tracker
