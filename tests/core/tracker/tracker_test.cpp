#include "core/tracker/tracker.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

#include "hal/firmware.hpp"
#include "host_sim/scenarios/paper.hpp"
#include "host_sim/world/renderer.hpp"
#include "tests/support/paper_transcription.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

using enum tracker::TrackingStatus;
using tracker::Reason;
using Scenario = sim::PaperScenario;
using M = Scenario::Model;
using Markers = std::vector<sim::SceneMarker>;

/// A tracker that looks at the paper's printer at rest, 30 frames a second, through a scene that a test may disturb.
class PrinterTracker : public testing::Test {
 protected:
  using Tracker = tracker::Tracker<M, double>;
  using Estimate = Tracker::EstimateType;

  Estimate see(const std::function<void(Markers&)>& disturb = [](Markers&) {}) {
    const double t_s = static_cast<double>(k_) / 30;
    Markers markers = sim::scene_markers<M>(Scenario::at(0).q);
    disturb(markers);
    renderer_.render(markers, static_cast<std::uint64_t>(k_++), pixels_);
    return tracker_->step({pixels_.data(), 640, 480, 640}, from_seconds(t_s));
  }
  Estimate see_nothing() {
    return see([](Markers& markers) { markers.clear(); });
  }
  void track() {
    Estimate estimate;
    for (int i = 0; i < 5; ++i) estimate = see();
    ASSERT_EQ(estimate.status, tracking) << name(estimate.reason);
  }
  static double drawer_error_mm(const Estimate& estimate) {
    return 1e3 * (estimate.q.joints[0] - Scenario::at(0).q.joints[0]);
  }

  sim::Renderer renderer_{Scenario::camera(), {}};
  std::unique_ptr<Tracker> tracker_ = std::make_unique<Tracker>(Scenario::camera());
  std::vector<std::uint8_t> pixels_;
  int k_{};
};

TEST_F(PrinterTracker, FindsThePrinterFromThePapersStartInTheFirstFrame) {
  const auto estimate = see();
  EXPECT_EQ(estimate.status, tracking) << name(estimate.reason);
  EXPECT_EQ(estimate.matched, 6);
  // 3 deviations of the drawer at this noise (0.02 mm), and as much again for a first frame without history.
  EXPECT_LT(std::abs(drawer_error_mm(estimate)), 0.15);
}

TEST_F(PrinterTracker, TracksWithABaseMarkerHiddenAndSaysWhichJointIsHeldWithADrawerMarkerHidden) {
  track();
  const auto without_base = see([](Markers& markers) { markers.erase(markers.begin()); });
  EXPECT_EQ(without_base.status, tracking);
  EXPECT_EQ(without_base.matched, 5);
  EXPECT_LT(std::abs(drawer_error_mm(without_base)), 0.3);
  const auto without_drawer = see([](Markers& markers) { markers.pop_back(); });
  EXPECT_EQ(without_drawer.status, degraded);
  EXPECT_EQ(without_drawer.reason, Reason::weak_joint);
  EXPECT_LT(without_drawer.covariance(6, 6), 1e-6);  // the drawer is seen by its other marker ...
  EXPECT_EQ(without_drawer.observability[7], tracker::Observability::held);  // ... the distance of the two is not:
  // what a frame of unknown acceleration leaves of it, and of the rate, which was known to a few mm/s.
  const double acceleration = tracker::Options{}.acceleration.slide_m;
  const double of_acceleration = acceleration * acceleration * 0.04 * 0.04 * 0.04 / 3;
  EXPECT_GT(without_drawer.covariance(7, 7), 0.5 * of_acceleration);
  EXPECT_LT(without_drawer.covariance(7, 7), 2 * of_acceleration);
}

TEST_F(PrinterTracker, LeavesOutAMarkerThatHasComeOff) {
  track();
  const auto estimate = see([](Markers& markers) { markers[1].centre_cam_m.x() += 0.015; });  // 11 px
  EXPECT_EQ(estimate.status, tracking);
  EXPECT_EQ(estimate.reason, Reason::outlier);
  EXPECT_EQ(estimate.matched, 5);
  EXPECT_LT(std::abs(drawer_error_mm(estimate)), 0.3);
}

TEST_F(PrinterTracker, CoastsWithGrowingCovarianceIsLostThenAndStandsStillUntilItSeesThePrinterAgain) {
  track();
  Estimate last = see();
  for (; last.status == tracking || last.status == coasting; last = see_nothing()) {
    ASSERT_TRUE(last.valid);
    ASSERT_LT(k_, 60);
  }
  EXPECT_EQ(last.status, lost);
  EXPECT_FALSE(last.valid);
  EXPECT_GT(k_, 5 + 15);  // half a second of coasting
  const auto later = see_nothing();
  EXPECT_EQ(later.q.T_cam_obj.t, last.q.T_cam_obj.t);
  EXPECT_GE(later.covariance(0, 0), last.covariance(0, 0));
  EXPECT_TRUE(math::all_finite(later.covariance));
  EXPECT_EQ(see().status, tracking);
}

TEST_F(PrinterTracker, RefusesAFrameThatCannotBeUsedAndIsTheSameAfterItBitForBit) {
  track();
  const auto other = std::make_unique<Tracker>(*tracker_);
  const Timestamp soon = from_seconds(0.16);
  EXPECT_EQ(tracker_->step({pixels_.data(), 320, 240, 640}, soon).reason, Reason::image_mismatch);
  EXPECT_EQ(tracker_->step({nullptr, 640, 480, 640}, soon).reason, Reason::image_mismatch);
  EXPECT_EQ(tracker_->step({pixels_.data(), 640, 480, 639}, soon).reason, Reason::image_mismatch);
  EXPECT_EQ(tracker_->step({pixels_.data(), 640, 480, 640}, from_seconds(0.1)).reason, Reason::stale_frame);
  EXPECT_EQ(tracker_->step({pixels_.data(), 320, 240, 640}, soon).status, coasting);
  const auto after = see();
  EXPECT_EQ(after.status, tracking);
  const auto undisturbed = other->step({pixels_.data(), 640, 480, 640}, after.t_capture);
  EXPECT_TRUE(after.q.joints == undisturbed.q.joints && after.covariance == undisturbed.covariance);
}

TEST_F(PrinterTracker, CallsAFirstImageOfAnotherSizeAFault) {
  pixels_.resize(320 * 240);
  const auto estimate = tracker_->step({pixels_.data(), 320, 240, 320}, from_seconds(0));
  EXPECT_EQ(estimate.status, fault);
  EXPECT_EQ(estimate.reason, Reason::image_mismatch);
  EXPECT_FALSE(estimate.valid);
}

TEST_F(PrinterTracker, CoastsADrawerThatIsHiddenWhileItMovesAndFindsItAgainWhereItStops) {
  k_ = 6 * 30;  // it opens
  const auto at_now = [&] { return Scenario::at(static_cast<double>(k_) / 30).q; };
  const auto moving = [&](bool hidden) {
    return see([&](Markers& markers) {
      markers = sim::scene_markers<M>(at_now());
      if (hidden) markers.resize(4);
    });
  };
  Estimate last;
  for (int i = 0; i < 15; ++i) last = moving(false);
  ASSERT_EQ(last.status, tracking) << name(last.reason);
  const double hidden_at = last.q.joints[0];
  double variance = 0;
  for (int i = 0; i < 60; ++i) {
    const double truth = at_now().joints[0];
    last = moving(true);
    ASSERT_EQ(last.status, degraded) << i << name(last.reason);
    EXPECT_EQ(last.reason, Reason::weak_joint);
    EXPECT_EQ(last.observability[6], tracker::Observability::held);
    EXPECT_GE(last.covariance(6, 6), variance);
    variance = last.covariance(6, 6);
    EXPECT_LT(std::abs(last.q.joints[0] - truth), 3 * std::sqrt(variance)) << i;
  }
  EXPECT_GT(std::abs(at_now().joints[0] - hidden_at), 0.02);  // it has gone on meanwhile ...
  const double found = at_now().joints[0];
  last = moving(false);
  EXPECT_EQ(last.status, tracking) << name(last.reason);  // ... and is found where it is
  EXPECT_NEAR(last.q.joints[0], found, 2e-4);
}

TEST_F(PrinterTracker, DoesNotCallTwoMarkersThatHaveComeOffTracking) {
  track();
  const auto estimate = see([](Markers& markers) {
    markers[0].centre_cam_m.y() += 0.0015;  // 1 px each, apart
    markers[2].centre_cam_m.y() -= 0.0015;
    markers[1].centre_cam_m.x() -= 0.0015;
  });
  EXPECT_EQ(estimate.status, degraded);
  EXPECT_EQ(estimate.reason, Reason::few_markers);  // those that agree have nothing to spare that would check them
}

TEST_F(PrinterTracker, CoastsOnATickWithoutAFrameAndLeavesTheNextFrameItsOwnTime) {
  track();
  auto other = std::make_unique<Tracker>(*tracker_);
  const auto coasted = tracker_->coast(from_seconds(0.25));
  EXPECT_EQ(coasted.status, coasting);
  EXPECT_EQ(coasted.reason, Reason::no_frame);
  EXPECT_EQ(coasted.t_capture, from_seconds(0.25));
  const auto after = see();
  const auto undisturbed = other->step({pixels_.data(), 640, 480, 640}, after.t_capture);
  EXPECT_TRUE(after.q.joints == undisturbed.q.joints && after.q.T_cam_obj.t == undisturbed.q.T_cam_obj.t);
}

TEST_F(PrinterTracker, PredictsAMovingDrawerToAControllersTimeAndSaysHowOldThatIs) {
  const double opens_s = 6;
  k_ = static_cast<int>(opens_s * 30);
  Estimate last;
  for (int i = 0; i < 30; ++i) {
    last = see([&](Markers& markers) { markers = sim::scene_markers<M>(Scenario::at(k_ / 30.0).q); });
  }
  ASSERT_EQ(last.status, tracking);
  const double t_s = k_ / 30.0, later_s = t_s + 0.010;  // a little after the next frame would have come
  const Timestamp later = from_seconds(later_s);
  const auto predicted = tracker_->predict(later);
  EXPECT_EQ(predicted.status, tracking);
  EXPECT_EQ(predicted.t, later);
  EXPECT_EQ(predicted.t_capture, last.t_capture);
  EXPECT_TRUE(predicted.valid);
  const double truth = Scenario::at(later_s).q.joints[0];
  EXPECT_GT(std::abs(truth - last.q.joints[0]), 1e-3);  // it has gone on
  EXPECT_LT(std::abs(predicted.q.joints[0] - truth), 3 * std::sqrt(predicted.covariance(6, 6)));
  EXPECT_GT(predicted.covariance(6, 6), last.covariance(6, 6));
  // Nothing has changed, the past is not predicted, and what is too old is lost.
  EXPECT_EQ(tracker_->predict(later).q.joints[0], predicted.q.joints[0]);
  EXPECT_EQ(tracker_->predict(from_seconds(t_s - 1)).t, last.t);
  const auto stale = tracker_->predict(from_seconds(t_s + 1));
  EXPECT_EQ(stale.status, lost);
  EXPECT_FALSE(stale.valid);
}

TEST_F(PrinterTracker, SaysOfEveryDegreeOfFreedomWhetherTheFrameObservedIt) {
  using enum tracker::Observability;
  track();
  const auto all = see();
  for (const auto seen : all.observability) EXPECT_EQ(seen, observed);
  const auto no_drawer = see([](Markers& markers) { markers.resize(4); });
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(no_drawer.observability[i], observed) << i;
  EXPECT_EQ(no_drawer.observability[6], held);
  EXPECT_EQ(no_drawer.observability[7], held);
  for (const auto seen : tracker_->coast(from_seconds(1)).observability) EXPECT_EQ(seen, held);
}

TEST_F(PrinterTracker, GivesFromRecordedDetectionsWhatItGaveFromTheImage) {
  const auto other = std::make_unique<Tracker>(Scenario::camera());
  for (int i = 0; i < 10; ++i) {
    const auto seen = see();
    const auto again = other->step(tracker_->detections(), tracker_->image_report(), seen.t_capture);
    EXPECT_TRUE(seen.q.joints == again.q.joints && seen.q.T_cam_obj.t == again.q.T_cam_obj.t &&
                seen.covariance == again.covariance && seen.status == again.status);
  }
}

TEST_F(PrinterTracker, GivesTheTransientOfThePapersModeAsInitialising) {
  tracker_ = std::make_unique<Tracker>(Scenario::camera(), tracker::Options{.mode = tracker::Mode::paper});
  const auto first = see();
  EXPECT_EQ(first.status, initialising);
  EXPECT_TRUE(first.valid);
  EXPECT_EQ(first.iterations, 1);
  Estimate last = first;
  for (int i = 0; i < 90; ++i) last = see();
  EXPECT_EQ(last.status, tracking);
  EXPECT_LT(last.error_norm, 1e-3 * first.error_norm);
  EXPECT_LT(std::abs(drawer_error_mm(last)), 0.5);  // the projected centre for the ellipse's: ANCHORS' bias, 0.2 px
}

TEST_F(PrinterTracker, InPapersModeFollowsTheTranscriptionOfEquations5And6FromFrameToFrame) {
  const tracker::Options options{.mode = tracker::Mode::paper};
  tracker_ = std::make_unique<Tracker>(Scenario::camera(), options);
  test::paper::Paper paper{test::paper::numbers(model::from_numbers<M, double>(M::kQ0).value())};
  for (int i = 0; i < 60; ++i) {
    const auto estimate = see();
    ASSERT_EQ(estimate.matched, 6) << i;
    Eigen::Matrix<double, 12, 1> s_star;
    for (int m = 0; m < 6; ++m) s_star.segment<2>(2 * m) = tracker_->matches()[static_cast<std::size_t>(m)].s_star;
    const double period_s = i == 0 ? 0.0 : seconds_between(from_seconds((i - 1) / 30.0), estimate.t_capture);
    paper.step(s_star, options.gain.slope, period_s);
    ASSERT_LT((test::paper::numbers(estimate.q) - paper.q()).cwiseAbs().maxCoeff(), 1e-12) << "frame " << i;
  }
}

TEST(Tracker, InPapersModeWithoutAStartSaysSoAndTouchesNoPixel) {
  const auto tracker = std::make_unique<tracker::Tracker<test::Arm, float>>(
      Scenario::camera(), tracker::Options{.mode = tracker::Mode::paper});
  const auto estimate = tracker->step({}, from_seconds(0));
  EXPECT_EQ(estimate.status, initialising);
  EXPECT_EQ(estimate.reason, Reason::no_start);
  EXPECT_FALSE(estimate.valid);
}

}  // namespace
}  // namespace articam
