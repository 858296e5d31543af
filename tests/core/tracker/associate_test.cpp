#include "core/tracker/associate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/observe.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;

TEST(Assignment, IsTheCheapestOfAllPairings) {
  test::Random random{16};
  constexpr std::size_t kRows = 4, kColumns = 5;
  for (int trial = 0; trial < 300; ++trial) {
    double cost[kRows][kColumns];
    for (auto& row : cost) {
      for (double& c : row)
        c = random.uniform(0, 1) < 0.2 ? std::numeric_limits<double>::infinity() : random.uniform(0, 2);
    }
    const auto column_of =
        math::assign<kRows, kColumns>(kRows, kColumns, 1.0, [&](std::size_t r, std::size_t c) { return cost[r][c]; });
    const auto price = [&](auto&& column) {
      double sum = 0;
      for (std::size_t r = 0; r < kRows; ++r) sum += column(r) < 0 ? 1.0 : cost[r][column(r)];
      return sum;
    };
    // All pairings: columns 5..8 of a permutation stand for "alone".
    std::vector<int> order(kRows + kColumns);
    std::iota(order.begin(), order.end(), 0);
    double best = std::numeric_limits<double>::infinity();
    do {
      best =
          std::min(best, price([&](std::size_t r) { return order[r] < static_cast<int>(kColumns) ? order[r] : -1; }));
      std::reverse(order.begin() + kRows, order.end());  // only the first four places matter
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_NEAR(price([&](std::size_t r) { return column_of[r]; }), best, 1e-12) << trial;
  }
}

vision::CameraModel<double> camera() {
  CameraParameters p;
  p.width_px = 640, p.height_px = 480, p.fx_px = p.fy_px = 525, p.cx_px = 319.5, p.cy_px = 239.5;
  return vision::CameraModel<double>{p};
}

vision::Detection detection_at(const tracker::Feature<double>& feature, Vec<double, 2> off, double size = 1) {
  const auto q16 = [](double x) { return static_cast<std::int32_t>(std::lround(x * 65536)); };
  vision::Detection d;
  d.kind = feature.kind;
  d.outer = {q16(feature.pixel.x() + off.x()), q16(feature.pixel.y() + off.y()), q16(size * feature.radius_px), 0,
             q16(0.9 * size * feature.radius_px)};
  d.centre_variance_q24 = 16 << 8;
  return d;
}

TEST(Associate, GivesEachMarkerItsOwnDetectionWhateverTheirOrder) {
  const auto features = tracker::predict_features<M, double>(test::nominal_printer<M, double>(), camera());
  vision::Detections detections;
  for (std::size_t i = features.size(); i-- > 0;)
    ASSERT_TRUE(detections.push_back(detection_at(features[i], {1.5, -2})));
  const auto matches = tracker::associate<M, double>(features, detections, camera(), 0.02);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    ASSERT_TRUE(matches[i].matched) << i;
    EXPECT_EQ(matches[i].detection, static_cast<int>(features.size() - 1 - i));
    const Vec<double, 2> s = (matches[i].pixel - Vec<double, 2>{319.5, 239.5}) / 525;
    EXPECT_LT((matches[i].s_star - s).norm(), 1e-12);
    EXPECT_NEAR(matches[i].variance, (16.0 / 65536 + 0.02 * 0.02) / (525.0 * 525.0), 1e-15);
  }
}

TEST(Associate, TakesNothingOutsideTheGateOfAnotherSizeOrOfAnotherKind) {
  const auto features = tracker::predict_features<M, double>(test::nominal_printer<M, double>(), camera());
  const auto matched_with = [&](const vision::Detection& d) {
    vision::Detections detections;
    EXPECT_TRUE(detections.push_back(d));
    return tracker::count<M, double>(tracker::associate<M, double>(features, detections, camera(), 0.02));
  };
  EXPECT_EQ(matched_with(detection_at(features[0], {0, 0})), 1);
  EXPECT_EQ(matched_with(detection_at(features[0], {60, 0})), 0);
  EXPECT_EQ(matched_with(detection_at(features[0], {0, 0}, 2.0)), 0);
  EXPECT_EQ(matched_with(detection_at(features[0], {0, 0}, 0.3)), 0);
  auto dot = detection_at(features[0], {0, 0});
  dot.kind = vision::MarkKind::dot_dark_on_light;
  EXPECT_EQ(matched_with(dot), 0);
}

/// Two features `apart_px` beside each other, alike but for the deviation of the second one's place.
tracker::Features<M, double> neighbours(double apart_px, double deviation_px) {
  auto features = tracker::predict_features<M, double>(test::nominal_printer<M, double>(), camera());
  for (std::size_t i = 1; i < features.size(); ++i) features[i].visible = false;
  features[1] = features[0];
  features[1].pixel.x() += apart_px;
  features[1].image.u_q16 += static_cast<std::int32_t>(65536 * apart_px);
  features[1].covariance = deviation_px * deviation_px * Mat<double, 2, 2>::Identity();
  return features;
}

TEST(Associate, GivesAMarkBetweenTwoFeaturesToTheOneWhosePlaceIsBetterKnown) {
  for (const double share : {0.1, 0.3, 0.5, 0.7}) {
    const auto features = neighbours(10, 30);  // as a joint that was hidden for a while is known
    vision::Detections detections;
    ASSERT_TRUE(detections.push_back(detection_at(features[0], {10 * share, 0})));
    const auto matches = tracker::associate<M, double>(features, detections, camera(), 0.02);
    EXPECT_TRUE(matches[0].matched) << share;
    EXPECT_FALSE(matches[1].matched) << share;
  }
}

TEST(Associate, LeavesAHiddenMarkerAloneRatherThanGivingItItsNeighboursMark) {
  for (const int hidden : {0, 1}) {
    const auto features = neighbours(40, 0);
    const auto seen = static_cast<std::size_t>(1 - hidden);
    for (const double off_px : {-15.0, -5.0, 0.0, 5.0, 15.0}) {
      vision::Detections detections;
      ASSERT_TRUE(detections.push_back(detection_at(features[seen], {off_px, 0})));
      const auto matches = tracker::associate<M, double>(features, detections, camera(), 0.02);
      EXPECT_TRUE(matches[seen].matched) << off_px;
      EXPECT_EQ((tracker::count<M, double>(matches)), 1) << off_px;
    }
  }
}

TEST(Associate, TellsTwoMarkersOfDifferentSizeApartWhereTheirPlacesDoNot) {
  auto features = neighbours(4, 8);
  features[0].covariance = features[1].covariance;
  auto& smaller = features[1].image;
  smaller.m00_q16 = smaller.m00_q16 / 4 * 3, smaller.m11_q16 = smaller.m11_q16 / 4 * 3;
  vision::Detections detections;  // each nearer to the other's place
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    ASSERT_TRUE(detections.push_back({.kind = features[i].kind, .outer = features[i].image}));
    detections[i].outer.u_q16 = features[1 - i].image.u_q16;
  }
  const auto matches = tracker::associate<M, double>(features, detections, camera(), 0.02);
  EXPECT_EQ(matches[0].detection, 0);
  EXPECT_EQ(matches[1].detection, 1);
}

TEST(Associate, LooksForNoMarkerThatFacesAwayOrIsOutsideTheImage) {
  auto q = test::nominal_printer<M, double>();
  q.T_cam_obj.R = math::exp_so3<double>({0, 3.14159, 0}) * q.T_cam_obj.R;  // seen from behind
  for (const auto& feature : tracker::predict_features<M, double>(q, camera())) EXPECT_FALSE(feature.visible);
  q = test::nominal_printer<M, double>();
  q.T_cam_obj.t.x() = 5;
  for (const auto& feature : tracker::predict_features<M, double>(q, camera())) EXPECT_FALSE(feature.visible);
}

}  // namespace
}  // namespace articam
