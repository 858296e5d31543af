#include "host_sim/report/figures.hpp"

#include <iterator>

#include "host_sim/report/histogram_figures.hpp"
#include "host_sim/report/paper_figures.hpp"
#include "host_sim/report/pull_figures.hpp"

namespace articam::sim {

Status draw_figures(const RunRecord& run, std::span<const FeedbackRun> feedbacks, Figures& figures) {
  const RunTable table{run};
  std::vector<Plan> plans = paper_figures(run, table);
  const std::size_t num_paper = plans.size();
  const std::vector<Plan> robot = pull_figures(run, feedbacks), counts = histogram_figures(run, table);
  plans.insert(plans.end(), robot.begin(), robot.end());
  plans.insert(plans.end(), counts.begin(), counts.end());
  std::vector<Figure> drawn;
  if (const Status status = draw(plans, drawn); status != Status::ok) return status;
  const auto robots = drawn.begin() + static_cast<std::ptrdiff_t>(num_paper);
  const auto counted = robots + static_cast<std::ptrdiff_t>(robot.size());
  figures.paper.assign(drawn.begin(), robots);
  figures.robot.assign(robots, counted);
  figures.counts.assign(counted, drawn.end());
  return Status::ok;
}

}  // namespace articam::sim
