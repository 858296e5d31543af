#include "core/tracker/innovation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/observe.hpp"

namespace articam::tracker {
namespace {

using M = models::PrinterDrawer;
using Step = Vec<double, model::kDof<M>>;
constexpr int kDraws = 20'000;

vision::CameraModel<double> camera() {
  return vision::CameraModel<double>{
      {.width_px = 640, .height_px = 480, .fx_px = 525, .fy_px = 525, .cx_px = 319.5, .cy_px = 239.5}};
}

/// What a tracker of 30 frames a second does not know of the next frame: 0.3 m/s and 1 rad/s.
Step deviations() {
  Step deviation = Step::Constant(0.01);
  deviation.segment<3>(3).setConstant(0.033);
  return deviation;
}

double log_area(const vision::Ellipse& e) {
  return std::log(vision::from_q16(e.m00_q16)) + std::log(vision::from_q16(e.m11_q16));
}

TEST(SpreadFeatures, IsTheCovarianceOfTheFeaturesOfConfigurationsThatAreSpreadSo) {
  test::Random random{31};
  const auto q = test::nominal_printer<M, double>();
  auto features = predict_features<M, double>(q, camera());
  const Step deviation = 0.1 * deviations();  // small, so that the image moves in proportion
  spread_features<M, double>(q, camera(), deviation.cwiseAbs2().asDiagonal(), features);
  std::array<Mat<double, 3, 3>, 6> sum{};
  for (auto& m : sum) m.setZero();
  for (int k = 0; k < kDraws; ++k) {
    Step step;
    for (int i = 0; i < step.size(); ++i) step[i] = deviation[i] * random.gaussian();
    const auto seen = predict_features<M, double>(model::integrate<M, double>(q, step), camera());
    for (std::size_t m = 0; m < seen.size(); ++m) {
      Vec<double, 3> off;
      off << seen[m].pixel - features[m].pixel, log_area(seen[m].image) - log_area(features[m].image);
      sum[m] += off * off.transpose() / kDraws;
    }
  }
  for (std::size_t m = 0; m < features.size(); ++m) {
    // A variance of 20,000 draws is known to 1 %: five times that, of the larger part.
    const double scale = features[m].covariance.trace();
    EXPECT_LT((sum[m].topLeftCorner<2, 2>() - features[m].covariance).norm(), 0.05 * scale) << m;
    EXPECT_NEAR(sum[m](2, 2), features[m].size_variance, 0.05 * features[m].size_variance) << m;
  }
}

TEST(SpreadFeatures, KeepsTheGateBetweenItsLeastAndItsMost) {
  const auto q = test::nominal_printer<M, double>();
  auto features = predict_features<M, double>(q, camera());
  const double least = std::sqrt(kGate<double>) * kUnmodelled_px<double>;
  for (const auto& feature : features) EXPECT_NEAR(reach_px(feature).norm(), std::sqrt(2.0) * least, 1e-9);
  spread_features<M, double>(q, camera(), Step::Constant(100).asDiagonal(), features);
  for (const auto& feature : features) {
    EXPECT_LE(reach_px(feature).squaredNorm(), kMaxReach_px<double> * kMaxReach_px<double> + 2 * least * least + 1e-6);
    EXPECT_LE(feature.size_variance, 1);
  }
}

/// The mark that a feature would be in a frame: its centre and its size drawn from the feature's own spread.
vision::Detection mark_of(const Feature<double>& feature, test::Random& random) {
  const Mat<double, 2, 2> l = feature.covariance.llt().matrixL();
  const Vec<double, 2> off = l * Vec<double, 2>{random.gaussian(), random.gaussian()};
  const double unmodelled = kUnmodelled_px<double>, size = 0.5 * kUnmodelledSize<double>;
  auto ellipse = vision::from_q16<double>(feature.image);
  ellipse.centre += off + unmodelled * Vec<double, 2>{random.gaussian(), random.gaussian()};
  ellipse.M *= std::exp(0.5 * std::sqrt(feature.size_variance) * random.gaussian() + size * random.gaussian());
  return {.kind = feature.kind, .outer = vision::to_q16(ellipse)};
}

TEST(Innovation, LetsAllButOneMarkInAThousandPassThatIsSpreadAsItSays) {
  test::Random random{32};
  const auto q = test::nominal_printer<M, double>();
  auto features = predict_features<M, double>(q, camera());
  spread_features<M, double>(q, camera(), deviations().cwiseAbs2().asDiagonal(), features);
  double sum = 0;
  int out = 0;
  for (int k = 0; k < kDraws; ++k) {
    const auto& feature = features[static_cast<std::size_t>(k) % features.size()];
    const auto found = innovation(feature, mark_of(feature, random));
    out += found.passes() ? 0 : 1;
    sum += std::min(found.centre + found.size, 50.0) / kDraws;
  }
  EXPECT_NEAR(sum, 3, 0.1);  // chi-square of 3; its mean over the draws is known to 0.02
  EXPECT_GT(out, 5);         // 20 are expected, with a deviation of 4.5
  EXPECT_LT(out, 40);
}

TEST(Innovation, IsInfiniteForAnotherKindAndGrowsWithTheSizeOfAnother) {
  const auto features = predict_features<M, double>(test::nominal_printer<M, double>(), camera());
  vision::Detection mark{.kind = features[0].kind, .outer = features[0].image};
  EXPECT_LT(innovation(features[0], mark).centre + innovation(features[0], mark).size, 1e-6);
  EXPECT_EQ(innovation(features[0], mark).width,
            innovation(features[1], {.kind = features[1].kind, .outer = features[1].image}).width);
  mark.outer.m00_q16 = mark.outer.m00_q16 / 5 * 4, mark.outer.m11_q16 = mark.outer.m11_q16 / 5 * 4;
  EXPECT_NEAR(innovation(features[0], mark).size, std::pow(2 * std::log(0.8) / kUnmodelledSize<double>, 2), 1e-2);
  mark.kind = vision::MarkKind::dot_dark_on_light;
  EXPECT_FALSE(innovation(features[0], mark).passes());
}

}  // namespace
}  // namespace articam::tracker
