#include "core/tracker/joint_limits.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/tracker/vvs.hpp"
#include "static_models/registry.hpp"
#include "tests/support/observe.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

using Arm = test::Arm;
using Printer = models::PrinterDrawer;

template <class M>
double quadratic_cost(const tracker::Normal<M, double>& normal, const Vec<double, model::kDof<M>>& step) {
  double cost = 0;
  for (int i = 0; i < model::kDof<M>; ++i) {
    cost -= normal.b[static_cast<std::size_t>(i)] * step[i];
    for (int j = 0; j < model::kDof<M>; ++j) cost += 0.5 * normal.H(i, j) * step[i] * step[j];
  }
  return cost;
}

bool is_within(const model::Configuration<Arm, double>& q, const Vec<double, 10>& step) {
  for (int j = 0; j < 4; ++j) {
    const auto& row = model::kValueRows<Arm>[static_cast<std::size_t>(j)];
    const double value = q.joints[j] + step[6 + j];
    if (value < row.q_min - 1e-9 || value > row.q_max + 1e-9) return false;
  }
  return true;
}

/// The least cost within the limits, by trying every choice of joints to hold, on either side.
double least_cost(const tracker::Normal<Arm, double>& normal, const model::Configuration<Arm, double>& q) {
  double least = std::numeric_limits<double>::infinity();
  for (int choice = 0; choice < 81; ++choice) {
    tracker::HeldJoints<Arm> held;
    for (int j = 0, rest = choice; j < 4; ++j, rest /= 3)
      held[static_cast<std::size_t>(j)] = static_cast<std::int8_t>(rest % 3 - 1);
    Vec<double, 10> step;
    const auto equations = tracker::detail::held_equations<Arm, double>(normal, 0.0, q, held);
    if (tracker::damped_step<Arm, double>(equations, 0.0, step) != Status::ok || !is_within(q, step)) continue;
    least = std::min(least, quadratic_cost<Arm>(normal, step));
  }
  return least;
}

TEST(JointLimits, TheStepIsTheBestOfAllThatKeepTheJointsWithinThem) {
  test::Random random{5};
  int bound = 0;
  for (int trial = 0; trial < 300; ++trial) {
    model::Configuration<Arm, double> q;
    for (int j = 0; j < 4; ++j) {
      const auto& row = model::kValueRows<Arm>[static_cast<std::size_t>(j)];
      q.joints[j] = random.uniform(std::max(row.q_min, -3.0), std::min(row.q_max, 3.0));
    }
    tracker::Normal<Arm, double> normal{};
    const Mat<double, 10, 10> A = [&] {
      Mat<double, 10, 10> X;
      for (int i = 0; i < 100; ++i) X(i) = random.gaussian();
      return X;
    }();
    for (int i = 0; i < 10; ++i) {
      normal.b[static_cast<std::size_t>(i)] = 6 * random.gaussian();
      for (int j = 0; j <= i; ++j) normal.H.at(i, j) = A.col(i).dot(A.col(j)) + (i == j ? 0.5 : 0.0);
    }
    Vec<double, 10> step;
    tracker::HeldJoints<Arm> held;
    ASSERT_EQ((tracker::limited_step<Arm, double>(normal, 0.0, q, step, held)), Status::ok);
    EXPECT_TRUE(is_within(q, step)) << trial;
    const double least = least_cost(normal, q);
    EXPECT_NEAR(quadratic_cost<Arm>(normal, step), least, 1e-9 * (1 + std::abs(least))) << trial;
    for (const auto side : held) bound += side != 0 ? 1 : 0;
  }
  EXPECT_GT(bound, 100);  // otherwise nothing was tried
}

TEST(JointLimits, HoldAJointThatTheMarksWantBeyondAndTheOthersGoWhereThatIsBest) {
  auto truth = test::nominal_printer<Printer, double>();
  truth.joints[0] = model::kValueRows<Printer>[0].q_max + 0.0003;
  const auto matches = test::observe<Printer, double>(truth, tracker::FeatureKind::imaged_circle);
  auto start = truth;
  start.joints[0] -= 0.02;
  const auto prior = tracker::independent_prior<Printer, double>(start, Vec<double, 8>::Constant(1));
  const auto solution = tracker::solve(matches, prior, start, 30);
  EXPECT_EQ(solution.q.joints[0], model::kValueRows<Printer>[0].q_max);
  EXPECT_TRUE(solution.converged);
  EXPECT_TRUE(solution.beyond_limit);
  // Nothing else can be moved to lower the cost.
  const auto normal = tracker::linearise(matches, prior, solution.q);
  for (int i = 0; i < 8; ++i) {
    if (i == 6) continue;
    EXPECT_NEAR(normal.b[static_cast<std::size_t>(i)] * std::sqrt(solution.covariance(i, i)), 0, 1e-2) << i;
  }
}

TEST(JointLimits, AreNotPressedByAJointThatRestsThereWithinItsNoise) {
  auto truth = test::nominal_printer<Printer, double>();
  truth.joints[0] = model::kValueRows<Printer>[0].q_min;
  test::Random random{7};
  int pressed = 0;
  for (int i = 0; i < 300; ++i) {
    const auto matches = test::observe<Printer, double>(truth, tracker::FeatureKind::imaged_circle, 0.05, &random);
    const auto prior = tracker::independent_prior<Printer, double>(truth, Vec<double, 8>::Constant(1));
    const auto solution = tracker::solve(matches, prior, truth, 30);
    ASSERT_TRUE(solution.converged);
    EXPECT_GE(solution.q.joints[0], truth.joints[0]);
    pressed += solution.beyond_limit ? 1 : 0;
  }
  EXPECT_LE(pressed, 3);  // beyond 3 deviations on one side: 1 in 740
}

}  // namespace
}  // namespace articam
