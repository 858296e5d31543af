#include "core/tracker/consensus.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "static_models/registry.hpp"
#include "tests/support/observe.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;
constexpr double kNoise_px = 0.05;
constexpr int kIterations = 20;
using Step = Vec<double, 8>;

/// What frames before have told: to `deviation`, m and rad.
tracker::Prior<M, double> known_to(double deviation, const model::Configuration<M, double>& mean) {
  return tracker::independent_prior<M, double>(mean, Step::Constant(deviation * deviation));
}

class ConsensusTest : public testing::Test {
 protected:
  using Configuration = model::Configuration<M, double>;
  tracker::Matches<M, double> observe() {
    return test::observe<M, double>(truth_, tracker::FeatureKind::imaged_circle, kNoise_px, &random_);
  }
  static void displace(tracker::Match<double>& match, Vec<double, 2> by_px) { match.s_star += by_px / test::kFocal_px; }
  /// Inside three deviations, each degree of freedom.
  void expect_honest(const tracker::Solution<M, double>& solution) const {
    const Step error = model::difference(truth_, solution.q);
    for (int i = 0; i < 8; ++i) EXPECT_LT(std::abs(error[i]), 3.5 * std::sqrt(solution.covariance(i, i))) << i;
  }

  const Configuration truth_ = test::nominal_printer<M, double>();
  test::Random random_{14};
};

TEST_F(ConsensusTest, LeavesOutAWildBaseMarkerAndAnswersAsIfItWereMissing) {
  const auto prior = known_to(0.02, truth_);
  for (std::size_t wild = 0; wild < 4; ++wild) {
    for (const double off_px : {5.0, 12.0, 30.0}) {
      auto matches = observe();
      auto without = matches;
      without[wild].matched = false;
      displace(matches[wild], Vec<double, 2>{0.6, -0.8} * off_px);
      const auto found = tracker::solve_with_consensus(matches, prior, truth_, kIterations);
      EXPECT_EQ(found.left_out.num_marks(), 1);
      EXPECT_FALSE(matches[wild].matched) << off_px;
      const auto clean = tracker::solve(without, prior, truth_, kIterations);
      EXPECT_LT(model::difference(clean.q, found.solution.q).norm(), 1e-12);
    }
  }
}

TEST_F(ConsensusTest, BlamesNobodyWhenAllAgree) {
  for (int i = 0; i < 200; ++i) {
    auto matches = observe();
    const auto found = tracker::solve_with_consensus(matches, known_to(0.02, truth_), truth_, kIterations);
    EXPECT_EQ(found.left_out.num_marks(), 0);
    EXPECT_FALSE(found.left_out.shapes || found.contradictory);
    EXPECT_EQ((tracker::count<M, double>(matches)), 6);
  }
}

TEST_F(ConsensusTest, LeavesOutALimitThatTheMarksContradictRatherThanThem) {
  Configuration beyond = truth_, at_limit = truth_;
  at_limit.joints[0] = M::kJoints[0].q_min;
  for (const double by_m : {0.002, 0.005, 0.01}) {
    beyond.joints[0] = M::kJoints[0].q_min - by_m;
    auto matches = test::observe<M, double>(beyond, tracker::FeatureKind::imaged_circle, kNoise_px, &random_);
    auto prior = known_to(0.02, at_limit);
    const auto found = tracker::solve_with_consensus(matches, prior, at_limit, kIterations);
    EXPECT_TRUE(found.left_out.limits && found.solution.beyond_limit) << by_m;
    EXPECT_EQ(found.left_out.num_marks(), 0);
    EXPECT_NEAR(found.solution.q.joints[0], beyond.joints[0], 4 * std::sqrt(found.solution.covariance(6, 6)));
    EXPECT_LT((found.solution.q.T_cam_obj.t - truth_.T_cam_obj.t).norm(), 0.001);
  }
}

TEST_F(ConsensusTest, LeavesOutTwoMarkersThatChangedPlaces) {
  for (int i = 0; i < 20; ++i) {
    auto matches = observe();
    std::swap(matches[0].s_star, matches[1].s_star);
    const auto found = tracker::solve_with_consensus(matches, known_to(0.02, truth_), truth_, kIterations);
    EXPECT_FALSE(matches[0].matched || matches[1].matched);
    EXPECT_FALSE(found.contradictory);
    expect_honest(found.solution);
  }
}

TEST_F(ConsensusTest, SaysThatThreeWildMarkersContradictTheOthers) {
  auto matches = observe();
  for (const std::size_t i : {0U, 1U, 2U}) displace(matches[i], {random_.uniform(20, 60), random_.uniform(20, 60)});
  EXPECT_TRUE(tracker::solve_with_consensus(matches, known_to(0.02, truth_), truth_, kIterations).contradictory);
}

TEST_F(ConsensusTest, RejectsADrawerMarkerThatThePriorContradicts) {
  for (const std::size_t wild : {4U, 5U}) {
    auto matches = observe();
    displace(matches[wild], {12, 0});  // 16 mm along the drawer's front, which is known to 1 mm
    const auto found = tracker::solve_with_consensus(matches, known_to(0.001, truth_), truth_, kIterations);
    EXPECT_FALSE(matches[wild].matched);
    expect_honest(found.solution);
  }
}

TEST_F(ConsensusTest, DisputesAJointWhereNothingTellsWhichOfItsMarkersLies) {
  Configuration pulled = truth_;
  pulled.joints[0] += 0.02;
  auto matches = observe();
  // Marker 4 says that the drawer is farther open, marker 5 that it is not, or else has another distance from it.
  matches[4] = test::observe<M, double>(pulled, tracker::FeatureKind::imaged_circle, kNoise_px, &random_)[4];
  const auto found = tracker::solve_with_consensus(matches, known_to(0.1, truth_), truth_, kIterations);
  EXPECT_TRUE(found.disputed[6]);
  for (int i = 0; i < 6; ++i) EXPECT_FALSE(found.disputed[static_cast<std::size_t>(i)]) << i;
  expect_honest(found.solution);
}

TEST_F(ConsensusTest, LeavesTheShapesOutWhereAllOfThemLie) {
  auto matches = observe();
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const auto kinematics = model::forward_kinematics<M, double>(truth_.joints);
    const auto circle =
        tracker::circle_in_camera(truth_.T_cam_obj, kinematics.markers[i], M::kMarkers[i].outer_diameter_m);
    const Mat<double, 2, 2> shape = vision::imaged_ellipse(circle).value().M;
    matches[i].shape = 1.1 * Vec<double, 3>{shape(0, 0), shape(1, 0), shape(1, 1)};  // overexposed
    matches[i].shape_variance = matches[i].variance;
  }
  const auto found = tracker::solve_with_consensus(matches, known_to(0.02, truth_), truth_, kIterations);
  EXPECT_TRUE(found.left_out.shapes);
  EXPECT_EQ(found.left_out.num_marks(), 0);
  expect_honest(found.solution);
}

}  // namespace
}  // namespace articam
