#include "host_sim/report/metrics.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/so3.hpp"

namespace articam::sim {
namespace {

constexpr double kDegPerRad = 180 / 3.14159265358979323846;

/// The value below which a share of the numbers lies; 0 of none.
double quantile(std::vector<double> numbers, double share) {
  if (numbers.empty()) return 0;
  const auto last = static_cast<double>(numbers.size() - 1);
  const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(share * last + 0.5);
  std::nth_element(numbers.begin(), place, numbers.end());
  return *place;
}

struct ErrorSums {
  double sum{}, squares{}, largest{};
  int count{};

  void add(double error) noexcept {
    sum += error;
    squares += error * error;
    largest = std::max(largest, std::abs(error));
    ++count;
  }
  double mean() const noexcept { return count == 0 ? 0 : sum / count; }
  double rms() const noexcept { return count == 0 ? 0 : std::sqrt(squares / count); }
};

double position_error_mm(const PlainConfiguration& found, const PlainConfiguration& truth) {
  return 1000 * (found.T_cam_obj.t - truth.T_cam_obj.t).norm();
}

double orientation_error_deg(const PlainConfiguration& found, const PlainConfiguration& truth) {
  return kDegPerRad * math::log_so3<double>(found.T_cam_obj.R * truth.T_cam_obj.R.conjugate()).norm();
}

JointMetrics evaluate_joint(const RunRecord& run, std::size_t joint) {
  std::vector<double> velocity, error;
  ErrorSums own, svd, rival;
  int within = 0;
  for (const FrameRecord& frame : run.frames) {
    if (frame.t_s < kEvaluatedFrom_s) continue;
    const double truth = frame.truth.joints[joint];
    if (frame.estimate) {
      velocity.push_back(frame.true_joint_rates[joint]);
      error.push_back(frame.estimate->joints[joint] - truth);
      own.add(1000 * error.back());
      if (frame.claimed && std::abs(error.back()) <= 3 * frame.claimed->joints[joint]) ++within;
    }
    if (frame.svd) svd.add(1000 * (frame.svd->joints[joint] - truth));
    if (frame.rival) rival.add(1000 * (frame.rival->joints[joint] - truth));
  }
  return {.name = run.joint_names[joint],
          .is_length = run.joint_is_length[joint],
          .rms = own.rms(),
          .mean = own.mean(),
          .max = own.largest,
          .svd_rms = svd.rms(),
          .rival_rms = rival.rms(),
          .within_3_sigma = own.count == 0 ? 0 : 1.0 * within / own.count,
          .lag_ms = lag_ms(velocity, error)};
}

void evaluate_base(const RunRecord& run, Metrics& metrics) {
  ErrorSums position, orientation, svd_position, svd_orientation, rival_position, rival_orientation, nees;
  std::vector<double> rms_px;
  for (const FrameRecord& frame : run.frames) {
    if (frame.t_s < kEvaluatedFrom_s) continue;
    if (frame.estimate) {
      position.add(position_error_mm(*frame.estimate, frame.truth));
      orientation.add(orientation_error_deg(*frame.estimate, frame.truth));
      rms_px.push_back(frame.rms_px);
    }
    if (frame.svd) {
      svd_position.add(position_error_mm(*frame.svd, frame.truth));
      svd_orientation.add(orientation_error_deg(*frame.svd, frame.truth));
    }
    if (frame.rival) {
      rival_position.add(position_error_mm(*frame.rival, frame.truth));
      rival_orientation.add(orientation_error_deg(*frame.rival, frame.truth));
    }
    if (frame.nees) nees.add(*frame.nees);
  }
  metrics.evaluated = position.count;
  metrics.position_rms_mm = position.rms();
  metrics.orientation_rms_deg = orientation.rms();
  metrics.svd_position_rms_mm = svd_position.rms();
  metrics.svd_orientation_rms_deg = svd_orientation.rms();
  metrics.rival_position_rms_mm = rival_position.rms();
  metrics.rival_orientation_rms_deg = rival_orientation.rms();
  metrics.median_rms_px = quantile(rms_px, 0.5);
  metrics.mean_nees = nees.mean();
}

}  // namespace

std::optional<Interval> lag_ms(std::span<const double> velocity, std::span<const double> error) noexcept {
  constexpr std::size_t kReach = 30;  // frames: one second
  const LineFit fit = fit_line(velocity, error, kReach);
  if (fit.slope_std == 0 && fit.slope == 0) return std::nullopt;
  const Interval slope = fit.slope_interval();
  return Interval{-1000 * slope.value, -1000 * slope.high, -1000 * slope.low};
}

std::optional<Interval> decay_rate(std::span<const double> t_s, std::span<const double> norm) noexcept {
  constexpr std::size_t kFewest = 5, kReach = 3;
  const std::size_t n = norm.size();
  if (n < 2 * kFewest) return std::nullopt;
  const double floor = quantile({norm.end() - static_cast<std::ptrdiff_t>(n / 5), norm.end()}, 0.5);
  std::vector<double> log_norm;
  for (std::size_t i = 0; i < n && norm[i] > 3 * floor; ++i) log_norm.push_back(std::log(norm[i]));
  if (log_norm.size() < kFewest) return std::nullopt;
  const Interval slope = fit_line(t_s.first(log_norm.size()), log_norm, kReach).slope_interval();
  return Interval{-slope.value, -slope.high, -slope.low};
}

Metrics evaluate(const RunRecord& run) {
  Metrics metrics;
  std::vector<double> t_s, norm, step_ms;
  for (const FrameRecord& frame : run.frames) {
    ++metrics.frames_by_status[static_cast<std::size_t>(frame.status)];
    step_ms.push_back(1000 * frame.step_s);
    if (frame.t_s >= run.rest_s || !frame.estimate) continue;
    t_s.push_back(frame.t_s);
    norm.push_back(frame.error_norm);
  }
  for (std::size_t j = 0; j < run.joint_names.size(); ++j) metrics.joints.push_back(evaluate_joint(run, j));
  evaluate_base(run, metrics);
  metrics.decay_rate_per_s = decay_rate(t_s, norm);
  metrics.step_median_ms = quantile(step_ms, 0.5);
  metrics.step_p99_ms = quantile(step_ms, 0.99);
  metrics.step_max_ms = quantile(step_ms, 1);
  return metrics;
}

}  // namespace articam::sim
