#include "core/tracker/shape_information.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/tracker/vvs.hpp"
#include "static_models/arm7/arm7.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "static_models/switch_panel/switch_panel.hpp"
#include "tests/support/observe.hpp"

namespace articam {
namespace {

constexpr double kFocal = test::kFocal_px;
constexpr double kShape_px = 0.02;

/// Centre and (m00, m10, m11) of a marker's image, its radius scaled by exp(u).
template <class M>
Vec<double, 5> image_of(const model::Configuration<M, double>& q, std::size_t marker, double u) {
  const auto kinematics = model::forward_kinematics<M, double>(q.joints);
  auto circle =
      tracker::circle_in_camera(q.T_cam_obj, kinematics.markers[marker], M::kMarkers[marker].outer_diameter_m);
  circle.radius *= std::exp(u);
  const auto image = vision::imaged_ellipse(circle).value();
  return {image.centre.x(), image.centre.y(), image.M(0, 0), image.M(1, 0), image.M(1, 1)};
}

/// Centres and shapes as a detector would give them, the marks printed too large by exp(u).
template <class M>
tracker::Matches<M, double> seen(const model::Configuration<M, double>& q, double u, double noise_px,
                                 test::Random& random) {
  auto matches = test::observe<M, double>(q, tracker::FeatureKind::imaged_circle, noise_px, &random);
  for (std::size_t m = 0; m < matches.size(); ++m) {
    if (!matches[m].matched) continue;
    const auto kinematics = model::forward_kinematics<M, double>(q.joints);
    const auto circle = tracker::circle_in_camera(q.T_cam_obj, kinematics.markers[m], 1);
    // Seen nearly edge on, a shape is not linear over any step.
    matches[m].matched = std::abs(circle.normal.dot(circle.centre.normalized())) > 0.3;
    if (!matches[m].matched) continue;
    const Vec<double, 5> image = image_of<M>(q, m, u), unscaled = image_of<M>(q, m, 0);
    matches[m].s_star += image.head<2>() - unscaled.head<2>();
    matches[m].shape = image.tail<3>();
    for (int i = 0; i < 3; ++i) matches[m].shape[i] += noise_px > 0 ? kShape_px / kFocal * random.gaussian() : 0;
    matches[m].shape_variance = kShape_px * kShape_px / (kFocal * kFocal);
  }
  return matches;
}

template <class M>
class ShapeInformation : public testing::Test {};
using Models = testing::Types<models::PrinterDrawer, models::SwitchPanel, models::Arm7>;
TYPED_TEST_SUITE(ShapeInformation, Models);

TYPED_TEST(ShapeInformation, IsThatOfTheNumericDerivativesWithTheScaleEliminated) {
  using M = TypeParam;
  constexpr int n = model::kDof<M>;
  test::Random random{41};
  for (int trial = 0; trial < 5; ++trial) {
    const auto q = random.configuration<M, double>();
    const auto near = model::integrate<M, double>(q, random.vector<double, n>(-2e-5, 2e-5));
    auto matches = seen<M>(near, 1e-4, 0, random);
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n + 1, n + 1);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 1);
    H(n, n) = 1 / (tracker::kPrintScale<double> * tracker::kPrintScale<double>);
    for (std::size_t m = 0; m < matches.size(); ++m) {
      if (!matches[m].matched) continue;
      Eigen::Matrix<double, 5, n + 1> A;
      constexpr double kStep = 1e-5;
      for (int i = 0; i <= n; ++i) {
        Vec<double, n> step = Vec<double, n>::Zero();
        if (i < n) step[i] = kStep;
        const double u = i == n ? kStep : 0;
        A.col(i) = (image_of<M>(model::integrate<M, double>(q, step), m, u) -
                    image_of<M>(model::integrate<M, double>(q, Vec<double, n>{-step}), m, -u)) /
                   (2 * kStep);
      }
      const auto& match = matches[m];
      Vec<double, 5> seen, certainty;
      seen << match.s_star, match.shape;
      certainty << Vec<double, 2>::Constant(1 / match.variance), Vec<double, 3>::Constant(1 / match.shape_variance);
      H += A.transpose() * certainty.asDiagonal() * A;
      b += A.transpose() * certainty.asDiagonal() * (seen - image_of<M>(q, m, 0));
    }
    const Eigen::VectorXd h = H.col(n).head(n);
    const Eigen::MatrixXd expected_H = H.topLeftCorner(n, n) - h * h.transpose() / H(n, n);
    const Eigen::VectorXd expected_b = b.head(n) - h * b[n] / H(n, n);

    const auto normal = tracker::linearise<M, double>(matches, q);
    ASSERT_EQ(normal.status, Status::ok);
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      EXPECT_NEAR(normal.b[at], expected_b[i], 1e-5 * (b.norm() + 1)) << i;
      for (int j = 0; j < n; ++j) EXPECT_NEAR(normal.H(i, j), expected_H(i, j), 1e-6 * H.norm()) << i << ' ' << j;
    }
  }
}

/// Deviations that a frame leaves of the printer fronto-parallel at 0.7 m, by the information of the equations.
TEST(ShapeInformationOfThePrinter, TellsADrawerSeenAlongItsAxisBetterThanCentresDo) {
  using M = models::PrinterDrawer;
  auto q = test::nominal_printer<M, double>();
  q.T_cam_obj.R = math::exp_so3<double>({0, 0, 0.0873});
  test::Random random{42};
  const auto both = seen<M>(q, 0, 0, random);
  auto centres = both;
  for (auto& match : centres) match.shape_variance = 0;
  const auto deviation = [&](const auto& matches) {
    Mat<double, 8, 8> P;
    EXPECT_EQ(math::invert(tracker::linearise<M, double>(matches, q).H, P), Status::ok);
    return std::sqrt(P(6, 6));
  };
  EXPECT_LT(deviation(both), 0.8 * deviation(centres));
}

TEST(ShapeInformationOfThePrinter, IsConsistentWhenThePrinterHasScaledTheMarks) {
  using M = models::PrinterDrawer;
  const auto truth = test::nominal_printer<M, double>();
  test::Random random{43};
  double nees = 0;
  constexpr int kTrials = 2000;
  const auto prior = tracker::independent_prior<M, double>(truth, Vec<double, 8>::Constant(1));
  for (int i = 0; i < kTrials; ++i) {
    const auto matches = seen<M>(truth, tracker::kPrintScale<double> * random.gaussian(), 0.02, random);
    const auto solution = tracker::solve(matches, prior, truth, 10);
    ASSERT_EQ(solution.status, Status::ok);
    const Vec<double, 8> error = model::difference<M, double>(solution.q, truth);
    nees += error.dot(solution.covariance.ldlt().solve(error)) / kTrials;
  }
  EXPECT_NEAR(nees, 8, 4 * std::sqrt(2 * 8.0 / kTrials));  // chi-square of 8 degrees of freedom
}

}  // namespace
}  // namespace articam
