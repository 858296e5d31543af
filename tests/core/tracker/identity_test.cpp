#include <gtest/gtest.h>

#include <memory>

#include "core/tracker/tracker.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/random_views.hpp"

// Marks that look alike keep their names from frame to frame. From true ellipses, 30 frames a second.
namespace articam::tracker {
namespace {

struct UnstartedPrinter : models::PrinterDrawer {
  static constexpr bool kHasQ0 = false;
};
using M = UnstartedPrinter;

class Identity : public testing::Test {
 protected:
  using Q = model::Configuration<M, double>;

  void SetUp() override {
    q_ = model::from_numbers<M, double>({0, 0.05, 0.7, 0.98, 0.15, 0.1, 0.05, 0.1, 0.15}).value();
    for (int i = 0; i < 5; ++i) ASSERT_EQ(see().status, TrackingStatus::tracking);
  }
  vision::Detections marks() { return test::detections_of<M>(q_, camera_, 0.02, random_); }
  Estimate<M, double> see() { return see(marks()); }
  Estimate<M, double> see(const vision::Detections& detections) {
    return tracker_->step(detections, {}, from_seconds(++frame_ / 30.0));
  }
  static vision::Detection moved(vision::Detection mark, double by_u_px) {
    mark.outer.u_q16 += static_cast<std::int32_t>(65536 * by_u_px);
    return mark;
  }
  /// Matches are of detections in the table's order.
  void expect_own_marks() {
    for (std::size_t m = 0; m < tracker_->matches().size(); ++m) {
      if (!tracker_->matches()[m].matched) continue;
      EXPECT_EQ(tracker_->matches()[m].detection, static_cast<int>(m));
    }
  }

  vision::CameraModel<double> camera_{
      {.width_px = 640, .height_px = 480, .fx_px = 525, .fy_px = 525, .cx_px = 319.5, .cy_px = 239.5}};
  test::Random random_{1};
  std::unique_ptr<Tracker<M, double>> tracker_ = std::make_unique<Tracker<M, double>>(camera_.parameters());
  Q q_{};
  int frame_{};
};

TEST_F(Identity, SurvivesALookAlikeBesideTheMarker) {
  for (const double by_px : {25.0, -25.0}) {
    auto detections = marks();
    ASSERT_TRUE(detections.push_back(moved(detections[1], by_px)));
    EXPECT_EQ(see(detections).status, TrackingStatus::tracking);
    expect_own_marks();
  }
}

TEST_F(Identity, SurvivesALookAlikeThatPassesOverAMarker) {
  for (int step = -20; step <= 20; ++step) {
    auto detections = marks();
    const double by_px = 4.0 * step;
    if (std::abs(by_px) > 8) {  // nearer, the two are one blot: neither is found
      ASSERT_TRUE(detections.push_back(moved(detections[1], by_px)));
      EXPECT_EQ(see(detections).status, TrackingStatus::tracking) << step;
    } else {
      detections[1].kind = vision::MarkKind::dot_dark_on_light;
      EXPECT_EQ(see(detections).matched, 5) << step;
    }
    expect_own_marks();
  }
}

TEST_F(Identity, SurvivesAMarkerThatIsHiddenWhileTheObjectMoves) {
  for (int step = 0; step < 30; ++step) {
    q_.T_cam_obj.t.x() += 0.002;
    auto detections = marks();
    if (step > 5 && step < 20) detections[2].kind = vision::MarkKind::dot_dark_on_light;
    EXPECT_EQ(see(detections).status, TrackingStatus::tracking) << step;
    expect_own_marks();
  }
}

TEST_F(Identity, IsFoundAgainByAcquisitionAfterALossWhereverTheObjectIsThen) {
  for (int i = 0; i < 20; ++i) (void)see({});
  ASSERT_EQ(see({}).status, TrackingStatus::lost);
  q_ = test::random_view<M>(camera_, {}, random_);
  const auto estimate = see();
  EXPECT_EQ(estimate.status, TrackingStatus::tracking) << name(estimate.reason);
  EXPECT_EQ(estimate.matched, 6);
  expect_own_marks();
}

}  // namespace
}  // namespace articam::tracker
