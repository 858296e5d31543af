#include "host_sim/report/moments.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/report/metrics.hpp"

namespace articam::sim {
namespace {

double speed(const FrameRecord& frame) {
  double fastest = 0;
  for (const double rate : frame.true_joint_rates) fastest = std::max(fastest, std::abs(rate));
  return fastest;
}

std::size_t at(const RunRecord& run, double t_s) {
  const auto later = std::ranges::lower_bound(run.frames, t_s, {}, &FrameRecord::t_s);
  return std::min(static_cast<std::size_t>(later - run.frames.begin()), run.frames.size() - 1);
}

std::size_t event(const RunRecord& run) {
  const auto from = run.frames.begin() + static_cast<std::ptrdiff_t>(at(run, kEvaluatedFrom_s));
  const auto odd = std::find_if(from, run.frames.end(), [](const FrameRecord& frame) {
    return frame.status != tracker::TrackingStatus::tracking;
  });
  const auto found = odd != run.frames.end() ? odd : std::ranges::max_element(from, run.frames.end(), {}, &speed);
  return static_cast<std::size_t>(found - run.frames.begin());
}

}  // namespace

Moments moments(const RunRecord& run) {
  Moments chosen;
  chosen.start = at(run, 0.33);
  chosen.event = event(run);
  const double begin_s = std::max(0.0, run.frames[chosen.event].t_s - 0.25 * kFilm_s);
  for (int i = 0; i < static_cast<int>(kFilm_s * kFilmRate_hz); ++i) {
    const std::size_t frame = at(run, begin_s + i / kFilmRate_hz);
    if (chosen.film.empty() || frame != chosen.film.back()) chosen.film.push_back(frame);
  }
  return chosen;
}

}  // namespace articam::sim
