#include "host_sim/report/metrics.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/host_sim/report/synthetic_run.hpp"

namespace articam::sim {
namespace {

TEST(Metrics, FindThePlantedLag) {
  const Metrics metrics = evaluate(test::late_run());
  ASSERT_TRUE(metrics.joints[0].lag_ms);
  // est(t) = true(t - lag) is -lag velocity only to first order; the rest is lag^2 / 2 times the acceleration.
  EXPECT_NEAR(metrics.joints[0].lag_ms->value, 1000 * test::kLag_s, 1);
  EXPECT_LT(metrics.joints[0].lag_ms->low, metrics.joints[0].lag_ms->value);
  EXPECT_FALSE(metrics.joints[1].lag_ms) << "a joint that stands still tells nothing";
}

TEST(Metrics, FindThePlantedRateOfDecay) {
  const Metrics metrics = evaluate(test::late_run());
  ASSERT_TRUE(metrics.decay_rate_per_s);
  EXPECT_NEAR(metrics.decay_rate_per_s->value, test::kDecay_per_s, 0.1);  // the floor bends the end of the curve
}

TEST(Metrics, HaveNoRateWhereTheFirstFrameIsAlreadyAtTheFloor) {
  const std::vector<double> t{0, .1, .2, .3, .4, .5, .6, .7, .8, .9, 1}, norm(11, 1e-4);
  EXPECT_FALSE(decay_rate(t, norm));
}

TEST(Metrics, CountFramesByStatusAndLeaveTheFirstSecondAndMissingEstimatesOut) {
  const Metrics metrics = evaluate(test::late_run());
  EXPECT_EQ(metrics.frames_by_status[static_cast<std::size_t>(tracker::TrackingStatus::tracking)], 299);
  EXPECT_EQ(metrics.frames_by_status[static_cast<std::size_t>(tracker::TrackingStatus::lost)], 1);
  EXPECT_EQ(metrics.evaluated, 269);
  EXPECT_NEAR(metrics.position_rms_mm, 3, 1e-9);
  EXPECT_NEAR(metrics.svd_position_rms_mm, 0, 1e-9);
}

TEST(MetricsJson, HoldsWhatWasMeasured) {
  const RunRecord run = test::late_run();
  const auto json = nlohmann::json::parse(metrics_json(run, evaluate(run)));
  EXPECT_EQ(json["scenario"], "paper");
  EXPECT_EQ(json["frames"], 300);
  EXPECT_EQ(json["frames_by_status"]["lost"], 1);
  EXPECT_NEAR(json["joints"]["slide"]["lag_ms"]["value"].get<double>(), 40, 1);
  EXPECT_TRUE(json["joints"]["distance"]["lag_ms"].is_null());
}

}  // namespace
}  // namespace articam::sim
