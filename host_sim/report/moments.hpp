#pragma once
/// @file  Which frames of a run are worth a look.

#include <cstddef>
#include <vector>

#include "host_sim/report/run_record.hpp"

namespace articam::sim {

/// Indices into run.frames.
struct Moments {
  std::size_t start{};  ///< a third of a second in: a slow estimate is still on its way
  std::size_t event{};  ///< after the first second, the first frame that is not tracked; else the fastest motion
  std::vector<std::size_t> film;  ///< kFilm_s around the event, kFilmRate_hz
};
inline constexpr double kFilm_s = 4, kFilmRate_hz = 7.5;

/// Of a run with at least one frame.
Moments moments(const RunRecord& run);

}  // namespace articam::sim
