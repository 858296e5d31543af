#include "core/tracker/paper_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/observe.hpp"
#include "tests/support/paper_transcription.hpp"

namespace articam {
namespace {

using namespace test::paper;
using M = models::PrinterDrawer;
using tracker::FeatureKind;

TEST(PaperLaw, FollowsTheIndependentTranscriptionOfEquations5And6FromThePapersStart) {
  const auto truth = test::nominal_printer<M, double>();
  const auto matches = test::observe<M, double>(truth, FeatureKind::point);
  const Eigen::Matrix<double, 12, 1> s_star = features(numbers(truth));
  const tracker::GainProfile profile;
  constexpr double Ts = 1.0 / 30;

  auto q = model::from_numbers<M, double>(M::kQ0).value();
  tracker::PaperIntegrator<M, double> integrator;
  Paper paper{numbers(q)};
  for (int k = 0; k < 120; ++k) {
    tracker::System<M, double> system;
    ASSERT_EQ(stack(matches, q, FeatureKind::point, system), Status::ok);
    const double lambda = tracker::gain(profile, system.e.norm());
    q = integrator.integrate(q, tracker::control_law(system, lambda, Vec<double, 12>(Vec<double, 12>::Zero())), Ts);
    paper.step(s_star, profile.slope, Ts);
    ASSERT_NEAR(lambda, paper.lambda(), 1e-12);
    ASSERT_LT((numbers(q) - paper.q()).cwiseAbs().maxCoeff(), 1e-12) << "frame " << k;
  }
  EXPECT_LT((numbers(q) - numbers(truth)).cwiseAbs().maxCoeff(), 1e-3);  // 4 s at lambda 5: it has arrived
}

TEST(PaperLaw, GivesTheSameMotionInTangentCoordinatesAsIn7PlusNRatesAlsoWithoutFullRank) {
  test::Random random{10};
  for (int missing = -1; missing < 6; ++missing) {  // without a drawer marker A loses rank
    const auto q = test::nominal_printer<M, double>();
    auto matches = test::observe<M, double>(model::integrate<M, double>(q, random.vector<double, 8>(-0.02, 0.02)),
                                            FeatureKind::point);
    if (missing >= 0) matches[static_cast<std::size_t>(missing)].matched = false;
    tracker::System<M, double> system;
    ASSERT_EQ(stack(matches, q, FeatureKind::point, system), Status::ok);
    const Vec<double, 12> s_star_dot = [&] {
      Vec<double, 12> rates = random.vector<double, 12>(-0.1, 0.1);
      if (missing >= 0) rates.segment<2>(2 * missing).setZero();
      return rates;
    }();
    const Vec<double, 8> ours = tracker::control_law(system, 3.0, s_star_dot);

    const Q9 x = numbers(q);
    Eigen::MatrixXd A = articulation(x);
    if (missing >= 0) A.middleRows<2>(2 * missing).setZero();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
    Eigen::VectorXd inverse = svd.singularValues();
    for (double& value : inverse) value = value > 1e-10 * svd.singularValues()[0] ? 1 / value : 0;
    const Q9 rates = svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose() * (s_star_dot - 3.0 * system.e);
    Vec<double, 8> paper;
    paper << rates.head<3>(), omega_of(x, rates), rates.tail<2>();
    // cond(A)^2 of about 4e4 times the rounding of the rates (up to 2 per second)
    EXPECT_LT((ours - paper).cwiseAbs().maxCoeff(), 1e-11) << "without marker " << missing;
  }
}

TEST(PaperLaw, FeedForwardCancelsTheErrorsGrowthUnderMotion) {
  // With e = 0 and s_star moving as A qdot, (5) returns that qdot.
  test::Random random{11};
  const auto q = test::nominal_printer<M, double>();
  tracker::System<M, double> system;
  ASSERT_EQ(stack(test::observe<M, double>(q, FeatureKind::point), q, FeatureKind::point, system), Status::ok);
  const Vec<double, 8> qdot = random.vector<double, 8>(-0.1, 0.1);
  const Vec<double, 12> s_star_dot = system.A * qdot;
  EXPECT_LT((tracker::control_law(system, 5.0, s_star_dot) - qdot).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PaperLaw, GainRunsFromItsMaximumAtZeroErrorToItsMinimumAndFallsAllTheWay) {
  const tracker::GainProfile profile;
  EXPECT_EQ(tracker::gain(profile, 0.0), 5.0);
  EXPECT_NEAR(tracker::gain(profile, 10.0), 2.0, 1e-12);
  for (double e = 0; e < 0.5; e += 0.01) EXPECT_GT(tracker::gain(profile, e), tracker::gain(profile, e + 0.01));
  EXPECT_NEAR((tracker::gain(profile, 0.0) - tracker::gain(profile, 1e-6)) / 1e-6, profile.slope, 1e-2);
}

}  // namespace
}  // namespace articam
