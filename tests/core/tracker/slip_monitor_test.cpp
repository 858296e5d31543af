#include "core/tracker/slip_monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/observe.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;
using tracker::SlipVerdict;
using Monitor = tracker::SlipMonitor<double>;
constexpr double kHand_m = 5e-4, kEye_m = 5e-5;

/// A drawer pulled and pushed sinusoidally by a hand with play; from a time on its grip slips, the drawer at rest,
/// until the hand has lost some way.
struct Grip {
  double play_m{}, slip_m{}, slip_time_s{};
  Monitor::Report report{};
  int alarms{};

  void run(double seconds, std::uint64_t seed) {
    test::Random random{seed};
    Monitor monitor;
    monitor.grasp();
    double drawer_m = 0, lost_m = 0, before_m = 0;
    for (int k = 0; k < static_cast<int>(30 * seconds); ++k) {
      const double t_s = k / 30.0, hand_m = 0.05 * (1 - std::cos(t_s));
      if (t_s >= slip_time_s && std::abs(lost_m) < slip_m) lost_m += hand_m - before_m;
      before_m = hand_m;
      const double least = hand_m - lost_m - play_m / 2, most = hand_m - lost_m + play_m / 2;
      drawer_m = drawer_m < least ? least : (drawer_m > most ? most : drawer_m);
      const double eye_m = drawer_m + kEye_m * random.gaussian();
      const double by_hand_m = hand_m + kHand_m * random.gaussian();
      report = monitor.update({by_hand_m - eye_m, kHand_m * kHand_m + kEye_m * kEye_m}, eye_m, kEye_m * kEye_m);
      alarms += report.verdict != SlipVerdict::agree;
    }
  }
};

TEST(SlipMonitor, SaysNothingOfAFirmGrip) {
  Grip grip;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) grip.run(20, seed);
  // 30,000 comparisons beyond 4 deviations (Gauss: 1 in 16,000), the three values of each not independent.
  EXPECT_LE(grip.alarms, 12);
}

TEST(SlipMonitor, TellsPlayOnceTheObjectHasMovedBothWays) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Grip grip{.play_m = 0.01};
    grip.run(2.5, seed);  // still pulling
    EXPECT_NE(grip.report.verdict, SlipVerdict::backlash);
    EXPECT_NE(grip.report.verdict, SlipVerdict::slip);
    grip.run(6, seed);
    EXPECT_EQ(grip.report.verdict, SlipVerdict::backlash);
    EXPECT_NEAR(grip.report.backlash, 0.01, 4 * std::sqrt(2.0) * kHand_m);
  }
}

TEST(SlipMonitor, TellsSlipFromPlay) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const double time_s : {1.5, 4.5}) {  // while pulling, and while pushing
      Grip grip{.play_m = 0.005, .slip_m = 0.02, .slip_time_s = time_s};
      grip.run(12, seed);
      EXPECT_EQ(grip.report.verdict, SlipVerdict::slip) << time_s;
      // A frame's way, 1.7 mm at most, may be lost beyond that.
      EXPECT_NEAR(grip.report.slip, time_s < 3.14 ? 0.02 : -0.02, 4 * std::sqrt(2.0) * kHand_m) << time_s;
      EXPECT_NEAR(grip.report.backlash, 0.005, 6 * kHand_m) << time_s;
    }
  }
}

TEST(HandDifference, IsHowFarTheHandIsAheadAlongTheDrawer) {
  tracker::Estimate<M, double> estimate;
  estimate.q = test::nominal_printer<M, double>();
  estimate.covariance.setIdentity();
  const int body = M::kMarkers.back().body;
  const Vec<double, 3> held{0.01, 0.02, 0.03};
  auto ahead = estimate.q;
  ahead.joints[0] += 0.004;
  const auto place = [&](const auto& q) -> Vec<double, 3> {
    const auto kinematics = model::forward_kinematics<M, double>(q.joints);
    return q.T_cam_obj * (kinematics.T_obj_body[static_cast<std::size_t>(body)] * held);
  };
  const auto d = tracker::hand_difference<M, double>(estimate, 0, body, held, place(ahead), 0);
  ASSERT_TRUE(d.ok());
  EXPECT_NEAR(d.value().value, 0.004, 1e-12);

  // var d = s^T P s with s the numeric slope of d by q.
  constexpr double kStep = 1e-6;
  double sum = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec<double, 8> step = kStep * Vec<double, 8>::Unit(i);
    auto moved = estimate;
    moved.q = model::integrate<M, double>(estimate.q, step);
    const Vec<double, 3> a = (place(ahead) - place(estimate.q)) / 0.004;
    const double slope = a.dot(place(moved.q) - place(estimate.q)) / a.squaredNorm() / kStep;
    sum += slope * slope;
  }
  EXPECT_NEAR(d.value().variance, sum, 1e-4 * sum);
}

TEST(HandDifference, RefusesAJointThatDoesNotMoveThePointAndNumbersThatAreNone) {
  tracker::Estimate<M, double> estimate;
  estimate.q = test::nominal_printer<M, double>();
  const Vec<double, 3> nowhere{std::nan(""), 0, 0};
  EXPECT_FALSE((tracker::hand_difference<M, double>(estimate, 1, 0, {0, 0, 0}, {0, 0, 1}, 1e-6).ok()));
  EXPECT_FALSE((tracker::hand_difference<M, double>(estimate, 0, 0, {0, 0, 0}, nowhere, 1e-6).ok()));
}

}  // namespace
}  // namespace articam
