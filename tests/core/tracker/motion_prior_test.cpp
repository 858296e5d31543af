#include "core/tracker/motion_prior.hpp"

#include <gtest/gtest.h>

#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/observe.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;
using Motion = tracker::MotionPrior<M, double>;
constexpr double kPeriod_s = 0.04;
const Mat<double, 8, 8> kTight = 1e-8 * Mat<double, 8, 8>::Identity();

TEST(MotionPrior, PredictsAConstantVelocityAfterAFewFrames) {
  Vec<double, 8> rates;
  rates << 0.1, -0.05, 0.02, 0.2, 0.1, -0.1, 0.05, 0;
  Motion motion{{}};
  auto truth = test::nominal_printer<M, double>();
  motion.start(truth);
  for (int k = 0; k < 40; ++k) {
    (void)motion.advance(from_seconds(k * kPeriod_s));
    if (k == 39) {
      EXPECT_LT(model::difference(motion.q(), truth).norm(), 1e-6);
    }
    motion.measured(truth, kTight, k > 0);
    truth = model::integrate<M, double>(truth, rates * kPeriod_s);
  }
  // What is left of the first surprise falls to a quarter in each frame; the rotation's bracket remains.
  EXPECT_LT((motion.rates() - rates).norm(), 1e-4);
}

TEST(MotionPrior, WidensWhileNothingIsMeasuredAndNoFurtherThanAtTheStart) {
  const tracker::Options options;
  Motion motion{options};
  motion.start(test::nominal_printer<M, double>());
  (void)motion.advance(from_seconds(0));
  motion.measured(test::nominal_printer<M, double>(), kTight, false);
  double last = 0;
  for (int k = 1; k < 100; ++k) {
    (void)motion.advance(from_seconds(0.04 * k));
    const double deviation = std::sqrt(motion.covariance()(6, 6));
    EXPECT_GE(deviation, last);
    last = deviation;
  }
  EXPECT_DOUBLE_EQ(last, options.start.slide_m);
}

TEST(MotionPrior, CarriesWhatOneFrameSaidOfTwoTogether) {
  Motion motion{{}};
  const auto q = test::nominal_printer<M, double>();
  motion.start(q);
  (void)motion.advance(from_seconds(0));
  Mat<double, 8, 8> covariance = kTight;
  covariance(6, 6) = covariance(7, 7) = 1e-4, covariance(6, 7) = covariance(7, 6) = 0.999e-4;
  motion.measured(q, covariance, false);
  (void)motion.advance(from_seconds(1e-3));
  const auto& information = motion.prior().information;
  EXPECT_LT((information * motion.covariance() - Mat<double, 8, 8>::Identity()).norm(), 1e-6);
  EXPECT_LT(information(6, 7), -0.9 * information(6, 6));
}

TEST(MotionPrior, IntegratesNoGapLongerThanStatedAndNoClockThatStandsOrGoesBack) {
  Motion motion{{}};
  const auto q = test::nominal_printer<M, double>();
  motion.start(q);
  EXPECT_EQ(motion.advance(from_seconds(10)), 0);  // first frame
  motion.measured(q, kTight, false);
  EXPECT_GT(motion.advance(from_seconds(10.04)), 0);
  motion.measured(model::integrate<M, double>(q, Vec<double, 8>::Constant(0.01)), kTight, true);
  const auto moved = motion.q();
  EXPECT_EQ(motion.advance(from_seconds(10.04)), 0);
  EXPECT_EQ(motion.advance(from_seconds(9)), 0);
  EXPECT_EQ(motion.advance(from_seconds(11)), 0);  // longer than max_gap_s
  EXPECT_EQ(model::difference(moved, motion.q()).norm(), 0);
}

}  // namespace
}  // namespace articam
