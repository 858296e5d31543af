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
    const double span_s = motion.advance(from_seconds(k * kPeriod_s));
    if (k == 39) {
      EXPECT_LT(model::difference(motion.q(), truth).norm(), 1e-6);
    }
    motion.measured(truth, kTight, span_s, k > 0);
    truth = model::integrate<M, double>(truth, rates * kPeriod_s);
  }
  EXPECT_LT((motion.rates() - rates).norm(),
            1e-4);  // 0.6^39 of the initial surprise is 2e-9; the rotation's bracket remains
}

TEST(MotionPrior, WidensWhileNothingIsMeasuredAndNoFurtherThanAtTheStart) {
  const tracker::Options options;
  Motion motion{options};
  motion.start(test::nominal_printer<M, double>());
  (void)motion.advance(from_seconds(0));
  motion.measured(test::nominal_printer<M, double>(), kTight, 0, false);
  (void)motion.advance(from_seconds(0.04));
  EXPECT_DOUBLE_EQ(std::sqrt(motion.prior().variance[0]), options.prior_base_m);  // 1e-4 + 0.012 is below the least
  double last = 0;
  for (int k = 2; k < 100; ++k) {
    (void)motion.advance(from_seconds(0.04 * k));
    const double deviation = std::sqrt(motion.prior().variance[6]);
    EXPECT_GE(deviation, last);
    last = deviation;
  }
  EXPECT_DOUBLE_EQ(last, options.start_slide_m);
}

TEST(MotionPrior, IntegratesNoGapLongerThanStatedAndNoClockThatStandsOrGoesBack) {
  Motion motion{{}};
  const auto q = test::nominal_printer<M, double>();
  motion.start(q);
  EXPECT_EQ(motion.advance(from_seconds(10)), 0);  // first frame
  motion.measured(q, kTight, 0, false);
  EXPECT_GT(motion.advance(from_seconds(10.04)), 0);
  motion.measured(model::integrate<M, double>(q, Vec<double, 8>::Constant(0.01)), kTight, 0.04, true);
  const auto moved = motion.q();
  EXPECT_EQ(motion.advance(from_seconds(10.04)), 0);
  EXPECT_EQ(motion.advance(from_seconds(9)), 0);
  EXPECT_EQ(motion.advance(from_seconds(11)), 0);  // longer than max_gap_s
  EXPECT_EQ(model::difference(moved, motion.q()).norm(), 0);
}

}  // namespace
}  // namespace articam
