#include "host_sim/report/voices.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace articam::sim {
namespace {

/// The paper's curve has triangles, as in the paper.
Speaker mode(RunTable::Voice voice, bool is_paper) {
  if (is_paper) return {voice, "paper''s mode", fmt::format("with linespoints pointinterval 90 {}", kPaper)};
  return {voice, "articam", fmt::format("with lines {}", kDefault)};
}

}  // namespace

Speaker truth() { return {RunTable::Voice::truth, "truth", fmt::format("with lines {}", kTruth)}; }

Speaker estimate(const RunRecord& run) { return mode(RunTable::Voice::estimate, run.mode == "paper"); }

std::vector<KeyEntry> key_of(const std::vector<Speaker>& speakers) {
  std::vector<KeyEntry> key;
  for (const Speaker& speaker : speakers) key.push_back({speaker.title, speaker.style});
  return key;
}

std::vector<Speaker> estimators(const RunRecord& run) {
  std::vector<Speaker> all;
  if (std::ranges::any_of(run.frames, [](const FrameRecord& frame) { return frame.svd.has_value(); })) {
    all.push_back({RunTable::Voice::svd, "SVD", fmt::format("with lines {}", kSvd)});
  }
  if (!run.rival_mode.empty()) all.push_back(mode(RunTable::Voice::rival, run.rival_mode == "paper"));
  all.push_back(estimate(run));
  return all;
}

}  // namespace articam::sim
