#include "host_sim/loop/simulated_loop.hpp"

#include <gtest/gtest.h>

#include "hal/firmware.hpp"
#include "host_sim/report/metrics.hpp"
#include "host_sim/report/pull_metrics.hpp"
#include "host_sim/scenarios/cabinet.hpp"
#include "host_sim/scenarios/door.hpp"
#include "host_sim/scenarios/valve.hpp"

namespace articam::sim {
namespace {

/// A robot moves the object as soon by what it sees as by the truth, and the tracker never lets go.
template <class Model>
void expect_pulled(const Scenario<Model>& scenario) {
  double settling_s[2]{};
  for (const Feedback feedback : {Feedback::standard, Feedback::truth}) {
    LoopOptions options;
    options.feedback = feedback;
    options.rendered = false;
    options.duration_s = scenario.duration_s;
    const LoopRun run = SimulatedLoop<tracker::Tracker<Model, double>>{scenario, options, {}}.run();
    ASSERT_EQ(run.problem, "");
    const auto metrics =
        evaluate_pull(run.samples, scenario.pull->commands, scenario.pull->settled, scenario.pull->control.period_s);
    EXPECT_EQ(metrics.settled, metrics.commands);
    EXPECT_EQ(run.control_failures, 0);
    settling_s[feedback == Feedback::truth] = metrics.settling_s;
    EXPECT_GE(run.by_status[static_cast<std::size_t>(tracker::TrackingStatus::tracking)],
              0.9 * 30 * scenario.duration_s);
  }
  EXPECT_LT(settling_s[0], 1.1 * settling_s[1]);
}

TEST(DoorScenario, IsSwungByWhatIsSeen) { expect_pulled(door_scenario()); }
TEST(ValveScenario, IsTurnedByWhatIsSeen) { expect_pulled(valve_scenario()); }
TEST(CabinetScenario, IsOpenedByWhatIsSeen) { expect_pulled(cabinet_scenario()); }

}  // namespace
}  // namespace articam::sim
