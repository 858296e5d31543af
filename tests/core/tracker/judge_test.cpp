#include "core/tracker/judge.hpp"

#include <gtest/gtest.h>

namespace articam {
namespace {

using enum tracker::TrackingStatus;
using tracker::Evidence;
using tracker::Judge;
using tracker::Reason;

constexpr Evidence kGood{.matched = 6, .redundant = true, .converged = true, .agrees = true};
Timestamp at(double t_s) { return from_seconds(t_s); }

TEST(Judge, TracksFromTheFirstGoodFrame) {
  Judge judge{{}};
  const auto verdict = judge.decide(kGood, at(0));
  EXPECT_EQ(verdict.status, tracking);
  EXPECT_EQ(verdict.reason, Reason::none);
}

TEST(Judge, InitialisesUntilThereIsAStartAndEnoughToSee) {
  Judge judge{{}};
  EXPECT_EQ(judge.decide({.has_start = false}, at(0)).reason, Reason::no_start);
  Evidence few = kGood;
  few.matched = 3, few.redundant = false;
  const auto verdict = judge.decide(few, at(0.1));
  EXPECT_EQ(verdict.status, initialising);
  EXPECT_EQ(verdict.reason, Reason::few_markers);
}

TEST(Judge, CoastsForTheStatedTimeAndIsLostThen) {
  Judge judge{{}};
  (void)judge.decide(kGood, at(0));
  const Evidence nothing{.matched = 0};
  EXPECT_EQ(judge.decide(nothing, at(0.2)).status, coasting);
  EXPECT_EQ(judge.decide(nothing, at(0.5)).status, coasting);
  EXPECT_EQ(judge.decide(nothing, at(0.51)).status, lost);
  EXPECT_EQ(judge.decide(nothing, at(9)).status, lost);
  EXPECT_EQ(judge.decide(kGood, at(9.1)).status, tracking);
}

TEST(Judge, CountsAStalledCameraAsNothingMeasured) {
  Judge judge{{}};
  (void)judge.decide(kGood, at(0));
  const auto verdict = judge.decide({.has_frame = false}, at(0.1));
  EXPECT_EQ(verdict.status, coasting);
  EXPECT_EQ(verdict.reason, Reason::no_frame);
}

TEST(Judge, IsDegradedWhereAJointIsHeldAndTrackingWhereOnlyAMarkerIsMissing) {
  Judge judge{{}};
  (void)judge.decide(kGood, at(0));
  Evidence weak = kGood;
  weak.weak = true, weak.matched = 5;
  EXPECT_EQ(judge.decide(weak, at(0.1)).status, degraded);
  EXPECT_EQ(judge.decide(weak, at(0.1)).reason, Reason::weak_joint);
  Evidence missing = kGood;
  missing.matched = 5;
  EXPECT_EQ(judge.decide(missing, at(0.2)).status, tracking);
  Evidence outlier = missing;
  outlier.outlier = true;
  EXPECT_EQ(judge.decide(outlier, at(0.3)).status, tracking);
  EXPECT_EQ(judge.decide(outlier, at(0.3)).reason, Reason::outlier);
}

TEST(Judge, NeverGivesAResidualThatDoesNotFitForAnEstimateAndCallsALastingOneAFault) {
  Judge judge{{}};
  (void)judge.decide(kGood, at(0));
  Evidence misfit = kGood;
  misfit.agrees = false;
  EXPECT_EQ(judge.decide(misfit, at(0.03)).status, coasting);
  tracker::Verdict verdict;
  for (int i = 2; i <= 30; ++i) verdict = judge.decide(misfit, at(0.03 * i));
  EXPECT_EQ(verdict.status, fault);
  EXPECT_EQ(verdict.reason, Reason::large_residual);
}

TEST(Judge, CallsAnImageOfAnotherSizeAFault) {
  Judge judge{{}};
  const auto verdict = judge.decide({.frame_fits = false}, at(0));
  EXPECT_EQ(verdict.status, fault);
  EXPECT_EQ(verdict.reason, Reason::image_mismatch);
}

}  // namespace
}  // namespace articam
