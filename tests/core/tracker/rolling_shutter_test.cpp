#include "core/tracker/rolling_shutter.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "hal/firmware.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/observe.hpp"
#include "tests/support/random_views.hpp"

namespace articam::tracker {
namespace {

using M = models::PrinterDrawer;
constexpr double kReadout_s = 0.015;

CameraParameters camera_read_in(double readout_s) {
  CameraParameters camera{
      .width_px = 640, .height_px = 480, .fx_px = 525, .fy_px = 525, .cx_px = 319.5, .cy_px = 239.5};
  camera.readout_time_s = readout_s;
  return camera;
}

/// The drawer opens at 50 mm/s while the whole drifts and turns.
model::Configuration<M, double> moving(double t_s) {
  auto q = test::nominal_printer<M, double>();
  Vec<double, 8> rates;
  rates << 0.03, -0.02, 0.01, 0.05, 0.02, -0.08, 0.05, 0;
  q.joints[0] = 0.02;
  return model::integrate<M, double>(q, rates * t_s);
}

/// Each mark where it is when its own row is exposed.
vision::Detections seen_row_by_row(double t_s, const vision::CameraModel<double>& camera, test::Random& random) {
  vision::Detections detections;
  const auto at_first = test::detections_of<M>(moving(t_s), camera, 0, random);
  for (std::size_t i = 0; i < at_first.size(); ++i) {
    double v = at_first[i].outer.v_q16 / 65536.0;
    vision::Detection mark;
    for (int round = 0; round < 4; ++round) {
      const double later_s = kReadout_s * v / 479;
      mark = test::detections_of<M>(moving(t_s + later_s), camera, 0.02, random)[i];
      v = mark.outer.v_q16 / 65536.0;
    }
    (void)detections.push_back(mark);
  }
  return detections;
}

/// Largest error of the drawer over a second of tracking, m.
double worst_drawer_error(double readout_that_the_tracker_knows_s) {
  const vision::CameraModel<double> camera{camera_read_in(0)};
  const auto tracker = std::make_unique<Tracker<M, double>>(camera_read_in(readout_that_the_tracker_knows_s));
  tracker->set_start(moving(0));
  test::Random random{3};
  double worst = 0;
  for (int k = 0; k < 45; ++k) {
    const double t_s = k / 30.0;
    const auto estimate = tracker->step(seen_row_by_row(t_s, camera, random), {}, from_seconds(t_s));
    EXPECT_EQ(estimate.status, TrackingStatus::tracking) << k;
    // What moves must first be known to move.
    if (k >= 15) worst = std::max(worst, std::abs(estimate.q.joints[0] - moving(t_s).joints[0]));
  }
  return worst;
}

TEST(RollingShutter, IsTakenBackMarkByMarkSoThatAMovingDrawerIsWhereItWasInTheFirstRow) {
  // 0.02 px are 0.03 mm of the drawer; where the rows' times are not known, the base goes on by 0.2 mm from one marker
  // to the next and 0.4 mm in the middle of the frame.
  EXPECT_LT(worst_drawer_error(kReadout_s), 1.5e-4);
  EXPECT_GT(worst_drawer_error(0), 2.5e-4);
}

TEST(RollingShutter, ExpectsAndTakesBackTheSame) {
  const vision::CameraModel<double> camera{camera_read_in(kReadout_s)};
  const auto q = test::nominal_printer<M, double>();
  auto features = predict_features<M, double>(q, camera);
  const auto still = features;
  for (auto& feature : features) feature.rate = {0.3, -0.2};
  delay_features<M, double>(camera, features);
  auto matches = test::observe<M, double>(q, FeatureKind::imaged_circle);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    matches[i].pixel = features[i].pixel;
    matches[i].s_star += features[i].rate * row_delay_s(camera.parameters(), still[i].pixel.y());
  }
  matches = without_delay<M, double>(camera, features, matches);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    // The row has moved by 1 px meanwhile: 3e-5 s of the delay.
    EXPECT_LT((matches[i].pixel - still[i].pixel).norm(), 0.01);
    EXPECT_LT((matches[i].s_star - test::observe<M, double>(q, FeatureKind::imaged_circle)[i].s_star).norm(), 2e-5);
  }
}

}  // namespace
}  // namespace articam::tracker
