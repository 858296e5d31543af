#include "core/tracker/consensus.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "static_models/registry.hpp"
#include "tests/support/observe.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;
constexpr double kNoise_px = 0.05;

tracker::Prior<M, double> tracking_prior(const model::Configuration<M, double>& mean) {
  return tracker::independent_prior<M, double>(mean, Vec<double, 8>::Constant(0.02 * 0.02));
}

TEST(Consensus, LeavesOutAWildBaseMarkerAndAnswersAsIfItWereMissing) {
  const auto truth = test::nominal_printer<M, double>();
  test::Random random{14};
  for (std::size_t wild = 0; wild < 4; ++wild) {
    for (const double off_px : {5.0, 12.0, 30.0}) {
      auto matches = test::observe<M, double>(truth, tracker::FeatureKind::imaged_circle, kNoise_px, &random);
      auto without = matches;
      without[wild].matched = false;
      matches[wild].s_star += Vec<double, 2>{0.6, -0.8} * (off_px / test::kFocal_px);
      const auto prior = tracking_prior(truth);
      const auto found = tracker::solve_with_consensus(matches, prior, truth, 9.0, 20);
      EXPECT_EQ(found.outlier, static_cast<int>(wild)) << off_px;
      EXPECT_FALSE(matches[wild].matched);
      const auto clean = tracker::solve(without, prior, truth, 20);
      EXPECT_LT(model::difference(clean.q, found.solution.q).norm(), 1e-12);
    }
  }
}

TEST(Consensus, BlamesNobodyWhenAllAgree) {
  const auto truth = test::nominal_printer<M, double>();
  test::Random random{15};
  for (int i = 0; i < 200; ++i) {
    auto matches = test::observe<M, double>(truth, tracker::FeatureKind::imaged_circle, kNoise_px, &random);
    EXPECT_EQ(tracker::solve_with_consensus(matches, tracking_prior(truth), truth, 9.0, 20).outlier, -1);
    EXPECT_EQ((tracker::count<M, double>(matches)), 6);
  }
}

TEST(Consensus, SaysThatTwoWildMarkersContradictTheOthers) {
  const auto truth = test::nominal_printer<M, double>();
  auto matches = test::observe<M, double>(truth, tracker::FeatureKind::imaged_circle, kNoise_px);
  std::swap(matches[0].s_star, matches[1].s_star);
  const auto found = tracker::solve_with_consensus(matches, tracking_prior(truth), truth, 9.0, 20);
  EXPECT_EQ(found.outlier, -1);
  EXPECT_TRUE(found.contradictory);
}

TEST(Consensus, BlamesNobodyWithoutSpareEquations) {
  const auto truth = test::nominal_printer<M, double>();
  auto matches = test::observe<M, double>(truth, tracker::FeatureKind::imaged_circle, kNoise_px);
  matches[0].matched = false;
  matches[1].s_star.x() += 0.02;
  EXPECT_EQ(tracker::solve_with_consensus(matches, tracking_prior(truth), truth, 9.0, 20).outlier, -1);
}

}  // namespace
}  // namespace articam
