#include "core/tracker/vvs.hpp"

#include <gtest/gtest.h>

#include "static_models/registry.hpp"
#include "tests/support/observe.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

using tracker::FeatureKind;
using Printer = models::PrinterDrawer;

template <class M, class S>
tracker::Prior<M, S> wide(const model::Configuration<M, S>& mean) {
  return tracker::independent_prior<M, S>(mean, Vec<S, model::kDof<M>>::Constant(S(1)));
}

template <class Scalar>
class Vvs : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(Vvs, Scalars);

TYPED_TEST(Vvs, FindsTheTruthFromTheAnchorsStart) {
  using S = TypeParam;
  const auto truth = test::nominal_printer<Printer, S>();
  const auto matches = test::observe<Printer, S>(truth, FeatureKind::imaged_circle);
  Vec<S, 8> off;  // 2 cm, 5 deg, 1 cm, as the anchors' solvers were started
  off << S(0.012), S(-0.01), S(0.013), S(0.05), S(-0.05), S(0.05), S(0.01), S(-0.01);
  const auto start = model::integrate<Printer, S>(truth, off);
  const auto solution = tracker::solve(matches, wide<Printer, S>(start), start, 20);
  ASSERT_EQ(solution.status, Status::ok);
  EXPECT_TRUE(solution.converged);
  EXPECT_LE(solution.iterations, 7);
  // A prior of 1 against 0.02 px pulls by 1e-9 of the way; float resolves about 1e-5 of the worst direction.
  EXPECT_LT(model::difference(truth, solution.q).cwiseAbs().maxCoeff(), sizeof(S) == 4 ? S(2e-4) : S(1e-7));
}

TEST(VvsSolve, ReachesTheCramerRaoBoundAndItsCovarianceIsTrue) {
  const auto truth = test::nominal_printer<Printer, double>();
  test::Random random{12};
  constexpr int kTrials = 2000;
  Mat<double, 8, 8> scatter = Mat<double, 8, 8>::Zero();
  double nees = 0;
  tracker::Solution<Printer, double> solution;
  for (int i = 0; i < kTrials; ++i) {
    const auto matches = test::observe<Printer, double>(truth, FeatureKind::imaged_circle, 0.3, &random);
    solution = tracker::solve(matches, wide<Printer, double>(truth), truth, 20);
    ASSERT_TRUE(solution.converged);
    const Vec<double, 8> error = model::difference(truth, solution.q);
    scatter += error * error.transpose() / kTrials;
    nees += error.dot(solution.covariance.inverse() * error) / kTrials;
  }
  // The anchors' bound at 0.3 px, open drawer: x y z mm, drawer q1, q2. 2,000 trials give each RMS to 1.6 %; Huber's
  // weights and the second-order bias may take 5 % together.
  const double bound_mm[]{0.175, 0.235, 1.046, 0.622, 0.500};
  const int dof[]{0, 1, 2, 6, 7};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(1e3 * std::sqrt(scatter(dof[i], dof[i])) / bound_mm[i], 1.0, 0.06) << dof[i];
  EXPECT_NEAR(nees, 8.0, 0.5);  // deviation of the mean of 2,000 chi-squares of 8 degrees: 0.09
}

TEST(VvsSolve, WorksForARigidObject) {
  using M = models::Mire;
  const auto truth = model::from_numbers<M, double>(M::kQ0).value();
  const auto matches = test::observe<M, double>(truth, FeatureKind::imaged_circle);
  const auto start = model::integrate<M, double>(truth, Vec<double, 6>::Constant(0.02));
  const auto solution = tracker::solve(matches, wide<M, double>(start), start, 20);
  ASSERT_TRUE(solution.converged);
  EXPECT_LT(model::difference(truth, solution.q).norm(), 1e-7);
}

TEST(VvsSolve, KeepsThePriorOfAJointThatNoMatchedMarkerShows) {
  const auto truth = test::nominal_printer<Printer, double>();
  auto matches = test::observe<Printer, double>(truth, FeatureKind::imaged_circle);
  matches[5].matched = false;  // the only marker that marker_distance moves
  auto prior = wide<Printer, double>(truth);
  prior.mean.joints[1] = 0.10;
  prior.information(7, 7) = 1 / (0.02 * 0.02);
  const auto solution = tracker::solve(matches, prior, prior.mean, 20);
  ASSERT_EQ(solution.status, Status::ok);
  EXPECT_NEAR(solution.q.joints[1], 0.10, 1e-9);
  EXPECT_NEAR(std::sqrt(solution.covariance(7, 7)), 0.02, 1e-9);
  EXPECT_NEAR(solution.q.joints[0], 0.08, 1e-5);
}

TEST(VvsSolve, LeavesTheStartAloneWhenTheObjectIsBehindTheCamera) {
  auto start = test::nominal_printer<Printer, double>();
  const auto matches = test::observe<Printer, double>(start, FeatureKind::imaged_circle);
  start.T_cam_obj.t.z() = -0.5;
  const auto solution = tracker::solve(matches, wide<Printer, double>(start), start, 20);
  EXPECT_EQ(solution.status, Status::behind_camera);
  EXPECT_EQ(solution.q.T_cam_obj.t.z(), -0.5);
}

TEST(VvsSolve, DoesTheSameBitForBitTwice) {
  const auto truth = test::nominal_printer<Printer, double>();
  test::Random random{13};
  const auto matches = test::observe<Printer, double>(truth, FeatureKind::imaged_circle, 0.3, &random);
  const auto a = tracker::solve(matches, wide<Printer, double>(truth), truth, 20);
  const auto b = tracker::solve(matches, wide<Printer, double>(truth), truth, 20);
  EXPECT_TRUE(a.q.T_cam_obj.t == b.q.T_cam_obj.t && a.q.joints == b.q.joints && a.covariance == b.covariance);
}

}  // namespace
}  // namespace articam
