#include "host_sim/report/pull_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace articam::sim {
namespace {

std::string style(const std::string& feedback) {
  if (feedback == "truth") return fmt::format("with lines {}", kTruth);
  if (feedback == "svd") return fmt::format("with lines {}", kSvd);
  if (feedback == "paper") return fmt::format("with linespoints pointinterval 60 {}", kPaper);
  return fmt::format("with lines {}", kDefault);
}

/// t, target, position, what was told wrongly, force; ten control periods a row.
std::string data_block(const FeedbackRun& run, double scale) {
  constexpr std::size_t kEvery = 10;
  std::string data = fmt::format("$pull_{} << END\n", run.feedback);
  for (std::size_t i = 0; i < run.samples.size(); i += kEvery) {
    const ControlSample& s = run.samples[i];
    data += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g} {:.4g}\n", s.t_s, scale * s.target, scale * s.position,
                        scale * (s.told - s.position), s.pull);
  }
  return data + "END\n";
}

}  // namespace

std::vector<Plan> pull_figures(const RunRecord& run, std::span<const FeedbackRun> feedbacks) {
  if (feedbacks.empty() || run.pulled_joint < 0) return {};
  const auto joint = static_cast<std::size_t>(run.pulled_joint);
  const std::string unit{joint_unit(run, joint)};
  // The truth's line is wide, so it comes first.
  std::vector<const FeedbackRun*> order;
  for (const FeedbackRun& feedback : feedbacks) order.push_back(&feedback);
  std::ranges::stable_sort(order, {}, [](const FeedbackRun* f) { return f->feedback != "truth"; });
  constexpr int kHeight_px = 540;
  std::string data, positions, told;
  std::vector<KeyEntry> key;
  double end_s = 0.1, hardest_pull = 1;
  for (const FeedbackRun* feedback : order) {
    if (feedback->samples.empty()) continue;
    end_s = std::max(end_s, feedback->samples.back().t_s);
    data += data_block(*feedback, joint_scale(run, joint));
    key.push_back({"by " + feedback->feedback, style(feedback->feedback)});
    positions += fmt::format("{}$pull_{} using 1:3 {}", positions.empty() ? "plot " : ", ", feedback->feedback,
                             key.back().style);
    told += fmt::format("{}$pull_{} using 1:4 {}", told.empty() ? "plot " : ", ", feedback->feedback, key.back().style);
  }
  if (feedbacks.front().samples.empty()) return {};
  const std::string& own = feedbacks.front().feedback;
  for (const ControlSample& sample : feedbacks.front().samples) hardest_pull = std::max(hardest_pull, sample.pull);
  key.push_back({"command", fmt::format("with lines {}", kCommand)});
  const std::string body =
      "set multiplot\n" + key_strip(key, kHeight_px) + fmt::format("set xrange [0:{}]\nset format x ''\n", end_s) +
      upright(fmt::format("joint [{}]", unit), 0.74) + place(0.155, 0.97, 0.55, 0.935) +
      fmt::format("{}, $pull_{} using 1:2 with steps {}\n", positions, own, kCommand) +
      upright(fmt::format("told wrongly [{}]", unit), 0.42) + place(0.155, 0.97, 0.325, 0.525) + told +
      fmt::format("\nset yrange [0:{}]\n", 1.05 * hardest_pull) + tics("y", {0, hardest_pull}, 5) +
      upright("pull [N]", 0.2) + "set format x '%g'\nset xlabel 'time [s]' offset 0,0.4\n" +
      place(0.155, 0.97, 0.105, 0.3) + fmt::format("plot $pull_{} using 1:5 {}\nunset multiplot\n", own, style(own));
  return {
      {"robot",
       "Above, the command and where the joint truly went. In the middle, what the controller was told of the joint, "
       "less the truth. Below, the force of the hand on the handle" +
           std::string(feedbacks.size() > 1 ? ", by feedback from <i>" + own + "</i>" : "") + ".",
       kHeight_px, data, body}};
}

}  // namespace articam::sim
