#pragma once
/// @file  Who says what in a figure, and how each looks.

#include <string>
#include <vector>

#include "host_sim/report/run_table.hpp"

namespace articam::sim {

struct Speaker {
  RunTable::Voice voice{};
  std::string title;
  std::string style;  ///< of gnuplot, from `with` on
};

/// A key of these.
std::vector<KeyEntry> key_of(const std::vector<Speaker>& speakers);

/// Whom a run knows beside the truth, in the order of drawing: the estimate last.
std::vector<Speaker> estimators(const RunRecord& run);
Speaker truth();
Speaker estimate(const RunRecord& run);

}  // namespace articam::sim
