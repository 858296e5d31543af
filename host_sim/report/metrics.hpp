#pragma once
/// @file  What a run was worth, in numbers.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host_sim/report/line_fit.hpp"
#include "host_sim/report/run_record.hpp"

namespace articam::sim {

/// Error figures leave the first second out: the tracker starts far off on purpose.
inline constexpr double kEvaluatedFrom_s = 1;

/// Delay of an estimate, ms: minus the slope of its error against the true velocity, as est(t) = true(t - lag) errs by
/// -lag * velocity. Errors may be correlated over a second. Nothing where the velocity does not vary.
std::optional<Interval> lag_ms(std::span<const double> velocity, std::span<const double> error) noexcept;

/// Rate of an exponential decay, 1/s: minus the slope of log(norm) against time, from the first frame until the norm
/// comes within 3 times its floor, the median of the last fifth. Nothing with fewer than 5 frames before that.
std::optional<Interval> decay_rate(std::span<const double> t_s, std::span<const double> norm) noexcept;

/// Of a joint: mm for lengths, mrad for angles.
struct JointMetrics {
  std::string name;
  bool is_length{};
  double rms{}, mean{}, max{};
  double svd_rms{};         ///< of the baseline; lengths only
  double rival_rms{};       ///< of the other mode; 0 where none ran
  double within_3_sigma{};  ///< share of errors within three of their claimed deviations
  std::optional<Interval> lag_ms;
};

struct Metrics {
  std::array<int, 6> frames_by_status{};  ///< in the order of TrackingStatus
  int evaluated{};                        ///< frames with an estimate after kEvaluatedFrom_s
  std::vector<JointMetrics> joints;
  double position_rms_mm{}, orientation_rms_deg{};
  double svd_position_rms_mm{}, svd_orientation_rms_deg{};
  double rival_position_rms_mm{}, rival_orientation_rms_deg{};
  double median_rms_px{};
  double mean_nees{};  ///< near the degrees of freedom where the covariance is true
  std::optional<Interval> decay_rate_per_s;
  double step_median_ms{}, step_p99_ms{}, step_max_ms{};  ///< of this machine: differ from run to run
};

Metrics evaluate(const RunRecord& run);

/// The contents of metrics.json.
std::string metrics_json(const RunRecord& run, const Metrics& metrics);

}  // namespace articam::sim
