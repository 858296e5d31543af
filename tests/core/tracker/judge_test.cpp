#include "core/tracker/judge.hpp"

#include <gtest/gtest.h>

namespace articam {
namespace {

using enum tracker::TrackingStatus;
using tracker::Evidence;
using tracker::Judge;
using tracker::Reason;

constexpr Evidence kGood{.matched = 6, .complete = true, .redundant = true, .converged = true, .agrees = true};
Timestamp at(double t_s) { return from_seconds(t_s); }

TEST(Judge, TracksFromTheFirstGoodFrame) {
  Judge judge{{}};
  const auto verdict = judge.decide(kGood, at(0));
  EXPECT_EQ(verdict.status, tracking);
  EXPECT_EQ(verdict.reason, Reason::none);
}

TEST(Judge, InitialisesUntilThereIsEnoughToSee) {
  Judge judge{{}};
  Evidence few = kGood;
  few.matched = 3, few.redundant = false;
  const auto verdict = judge.decide(few, at(0.1));
  EXPECT_EQ(verdict.status, initialising);
  EXPECT_EQ(verdict.reason, Reason::few_markers);
}

TEST(Judge, IsLostWhenAStartIsNotFoundInTheTimeThatAPredictionIsWorth) {
  Judge judge{{}};
  const Evidence nothing{.matched = 0};
  EXPECT_EQ(judge.decide(nothing, at(7.0)).status, initialising);
  EXPECT_EQ(judge.decide(nothing, at(7.5)).status, initialising);
  EXPECT_EQ(judge.decide(nothing, at(7.51)).status, lost);
  EXPECT_EQ(judge.unmeasured(Reason::no_frame, at(7.6)).status, lost);
  EXPECT_EQ(judge.decide(kGood, at(9)).status, tracking);
  Judge papers{{.mode = tracker::Mode::paper}};
  (void)papers.decide(nothing, at(7.0));
  EXPECT_EQ(papers.decide(nothing, at(9.0)).status, initialising);  // its law converges over seconds
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
  EXPECT_EQ(judge.unmeasured(Reason::no_frame, at(0)).status, initialising);
  (void)judge.decide(kGood, at(0));
  EXPECT_EQ(judge.unmeasured(Reason::no_frame, at(0.1)).status, coasting);
  EXPECT_EQ(judge.unmeasured(Reason::no_frame, at(0.1)).reason, Reason::no_frame);
  EXPECT_EQ(judge.unmeasured(Reason::no_frame, at(0.6)).status, lost);
}

TEST(Judge, FollowsWhatCannotCheckItselfNoLongerThanItCoasts) {
  Judge judge{{}};
  (void)judge.decide(kGood, at(0));
  const Evidence one{.matched = 1, .converged = true, .agrees = true, .weak = true};
  EXPECT_EQ(judge.decide(one, at(0.3)).status, degraded);
  EXPECT_EQ(judge.decide(one, at(0.6)).status, lost);
}

TEST(Judge, IsDegradedWhereTheMatchesContradictEachOtherWithinTheResidualsBound) {
  Judge judge{{}};
  Evidence swapped = kGood;
  swapped.contradictory = true;
  EXPECT_EQ(judge.decide(swapped, at(0)).status, degraded);
  EXPECT_EQ(judge.decide(swapped, at(0)).reason, Reason::large_residual);
}

TEST(Judge, NamesAnOverloadedFrameAndIterationsThatStillMove) {
  Judge judge{{}};
  Evidence moving = kGood;
  moving.converged = false;
  EXPECT_EQ(judge.decide(moving, at(0)).reason, Reason::not_converged);
  EXPECT_EQ(judge.decide(moving, at(0)).status, initialising);
  (void)judge.decide(kGood, at(0.1));
  EXPECT_EQ(judge.decide(moving, at(0.2)).status, degraded);
  Evidence overload = kGood;
  overload.image.overloaded = true;
  EXPECT_EQ(judge.decide(overload, at(0.3)).status, degraded);
  EXPECT_EQ(judge.decide(overload, at(0.3)).reason, Reason::overload);
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
  EXPECT_EQ(judge.decide(kGood, at(2)).status, tracking);
}

TEST(Judge, CallsItAFaultWhereAllMarkersAreSeenAndTooManyHadToBeLeftOutForLong) {
  Judge judge{{}};
  (void)judge.decide(kGood, at(0));
  Evidence few = kGood;
  few.matched = 4, few.redundant = false, few.weak = true;
  for (int i = 1; i < 30; ++i) EXPECT_NE(judge.decide(few, at(0.03 * i)).status, fault) << i;
  EXPECT_EQ(judge.decide(few, at(0.9)).status, fault);
  EXPECT_EQ(judge.decide(kGood, at(1)).status, tracking);
}

TEST(Judge, CallsClutterInPlaceOfAnAbsentObjectNoFault) {
  Judge judge{{}};
  (void)judge.decide(kGood, at(0));
  Evidence clutter = kGood;
  clutter.agrees = false, clutter.complete = false;
  for (int i = 1; i < 100; ++i) EXPECT_NE(judge.decide(clutter, at(0.03 * i)).status, fault);
}

TEST(Judge, NamesTheImageAsTheCauseOfWhatItMayHaveCaused) {
  Judge judge{{}};
  Evidence evidence = kGood;
  evidence.image.fault = Reason::blurred;
  EXPECT_EQ(judge.decide(evidence, at(0)).status, tracking);
  EXPECT_EQ(judge.decide(evidence, at(0.1)).reason, Reason::blurred);
  evidence.outlier = true;
  EXPECT_EQ(judge.decide(evidence, at(0.2)).reason, Reason::outlier);
  evidence.weak = true;
  EXPECT_EQ(judge.decide(evidence, at(0.3)).status, degraded);
  EXPECT_EQ(judge.decide(evidence, at(0.4)).reason, Reason::blurred);
  const Evidence nothing{.image = {.fault = Reason::underexposed}};
  EXPECT_EQ(judge.decide(nothing, at(0.5)).status, coasting);
  EXPECT_EQ(judge.decide(nothing, at(2)).status, lost);
  EXPECT_EQ(judge.decide(nothing, at(2.1)).reason, Reason::underexposed);
  EXPECT_EQ(judge.decide({.image = {true, Reason::blurred}}, at(2.2)).reason, Reason::overload);
}

}  // namespace
}  // namespace articam
