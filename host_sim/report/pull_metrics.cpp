#include "host_sim/report/pull_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace articam::sim {
namespace {

struct Step {
  double from_s, to_s, start, target;
};

/// The commands after the first, each until the next or the end.
std::vector<Step> steps_of(std::span<const ControlSample> samples, std::span<const JointCommand> commands) {
  std::vector<Step> steps;
  for (std::size_t i = 1; i < commands.size() && commands[i].t_s < samples.back().t_s; ++i) {
    const double to_s =
        i + 1 < commands.size() ? std::min(commands[i + 1].t_s, samples.back().t_s) : samples.back().t_s;
    steps.push_back({commands[i].t_s, to_s, commands[i - 1].target, commands[i].target});
  }
  return steps;
}

std::span<const ControlSample> during(std::span<const ControlSample> samples, double from_s, double to_s) {
  const auto before = [](const ControlSample& sample, double t_s) { return sample.t_s < t_s; };
  const auto first = std::lower_bound(samples.begin(), samples.end(), from_s, before);
  return {first, std::lower_bound(first, samples.end(), to_s, before)};
}

struct Sums {
  double squares{}, peak{};
  long count{};

  void add(double x) noexcept {
    squares += x * x;
    peak = std::max(peak, std::abs(x));
    ++count;
  }
  double rms() const noexcept { return count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count)); }
};

double hand_jerk(std::span<const ControlSample> samples, double period_s) {
  Sums jerk;
  for (std::size_t i = 2; i < samples.size(); ++i) {
    const Vec<double, 3> second =
        samples[i].hand_velocity - 2 * samples[i - 1].hand_velocity + samples[i - 2].hand_velocity;
    jerk.add(second.norm() / (period_s * period_s));
  }
  return jerk.rms();
}

}  // namespace

PullMetrics evaluate_pull(std::span<const ControlSample> samples, std::span<const JointCommand> commands, double near,
                          double period_s) {
  PullMetrics metrics;
  if (samples.empty() || commands.empty()) return metrics;
  const std::vector<Step> steps = steps_of(samples, commands);
  metrics.commands = static_cast<int>(steps.size());
  for (const Step& step : steps) {
    const double direction = step.target < step.start ? -1 : 1;
    double near_since_s = step.from_s, beyond = 0;
    bool outside = false;
    for (const ControlSample& sample : during(samples, step.from_s, step.to_s)) {
      beyond = std::max(beyond, direction * (sample.position - step.target));
      outside = std::abs(sample.position - step.target) > near;
      if (outside) near_since_s = sample.t_s + period_s;
    }
    metrics.overshoot = std::max(metrics.overshoot, 1000 * beyond);
    if (outside) continue;
    ++metrics.settled;
    metrics.settling_s += near_since_s - step.from_s;
  }
  if (metrics.settled > 0) metrics.settling_s /= metrics.settled;

  Sums error, told;
  for (const Step& step : steps) {
    for (const ControlSample& sample : during(samples, step.from_s + kAtRest_s, step.to_s)) {
      error.add(1000 * (sample.position - step.target));
    }
  }
  const auto on = during(samples, commands.front().t_s, samples.back().t_s + period_s);
  for (const ControlSample& sample : on) told.add(1000 * (sample.told - sample.position));
  metrics.error_rms = error.rms(), metrics.error_peak = error.peak;
  metrics.told_rms = told.rms(), metrics.told_peak = told.peak;
  metrics.jerk_rms = hand_jerk(on, period_s);
  return metrics;
}

}  // namespace articam::sim
