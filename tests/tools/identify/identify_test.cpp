#include "tools/identify/identify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "static_models/door/door.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "static_models/steering_wheel/steering_wheel.hpp"
#include "tests/tools/identify/synthetic_recording.hpp"

namespace articam::identify {
namespace {

using models::Door, models::PrinterDrawer, models::SteeringWheel;
using test::Random, test::World;
using Part = Judgement::Part;

constexpr int kSlide = PrinterDrawer::Joint::kDrawerSlide, kDistance = PrinterDrawer::Joint::kMarkerDistance;
constexpr double kTrueDistance_m = 0.12;
constexpr int kMoments = 60;

/// The printer from everywhere, its drawer anywhere, its second drawer marker at kTrueDistance_m.
Findings identify_printer(const World<PrinterDrawer>& world, std::uint64_t seed, bool places) {
  Random random{seed};
  const auto recording = test::record(world, {{kDistance, kTrueDistance_m}}, kMoments, random);
  const auto findings = identify(Object::of<PrinterDrawer>(), cameras::kXtionVga, recording, {{kDistance}, places});
  EXPECT_TRUE(findings && findings->converged);
  return findings.value_or(Findings{});
}

double share_of_deviation(const Length& length, double truth) { return (length.value - truth) / length.deviation; }

const Judgement& of(const Findings& findings, Part part) {
  return *std::ranges::find(findings.camera, part, &Judgement::part);
}

/// Every judgement but that one agrees with the camera file.
void expect_only_wrong(const Findings& findings, std::optional<Part> part) {
  for (const Judgement& judgement : findings.camera) {
    EXPECT_TRUE(judgement.told);
    EXPECT_EQ(judgement.wrong(), judgement.part == part) << "part " << static_cast<int>(judgement.part);
  }
}

/// Each marker within 3 deviations of its true displacement, those held exactly (a marker beyond the constant joint,
/// along it) within a micrometre.
void expect_places(const Findings& findings, const std::vector<Vec3>& truth) {
  ASSERT_EQ(findings.places.size(), truth.size());
  for (std::size_t m = 0; m < truth.size(); ++m) {
    const MarkerPlace& place = findings.places[m];
    for (int i = 0; i < 3; ++i) {
      const double deviation = std::sqrt(std::max(place.covariance(i, i), 0.0));
      EXPECT_NEAR(place.displaced[i], truth[m][i], 3 * deviation + 1e-6) << place.marker << ' ' << i;
    }
    EXPECT_EQ(place.reference, truth[m].norm() == 0) << place.marker;
  }
}

TEST(Identify, FindsAConstantDistanceAsCertainlyAsItSays) {
  double sum = 0;
  constexpr int kRuns = 8;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    const Findings findings = identify_printer({}, seed, false);
    ASSERT_EQ(findings.lengths.size(), 1u);
    EXPECT_EQ(findings.lengths[0].joint, "marker_distance");
    EXPECT_LT(findings.lengths[0].deviation, 0.02e-3);  // 80 frames at 0.02 px
    sum += std::pow(share_of_deviation(findings.lengths[0], kTrueDistance_m), 2);
  }
  // Chi-squared of 8 degrees of freedom: from 0.9 to 26 in 99.8 % of all seeds.
  EXPECT_GT(sum, 0.9);
  EXPECT_LT(sum, 26);
}

TEST(Identify, FindsAConstantAngleAlso) {
  Random random{3};
  constexpr double kTilt_rad = 0.1;
  const auto recording = test::record(World<SteeringWheel>{}, {{0, kTilt_rad}}, kMoments, random);
  for (const bool places : {false, true}) {
    const auto findings = identify(Object::of<SteeringWheel>(), cameras::kXtionVga, recording, {{0}, places});
    ASSERT_TRUE(findings && findings->lengths.size() == 1);
    EXPECT_FALSE(findings->lengths[0].slides);
    EXPECT_LT(std::abs(share_of_deviation(findings->lengths[0], kTilt_rad)), 3);
    EXPECT_LT(findings->lengths[0].deviation, 2e-4);
  }
}

TEST(Identify, FindsADisplacedMarkerAndLeavesTheOthersWhereTheyAre) {
  constexpr double kFar_m = 3e-3;
  for (const auto& [marker, d] :
       {std::pair{1u, Vec3{kFar_m, 0, 0}}, {1u, Vec3{0, 0, kFar_m}}, {4u, Vec3{0, kFar_m, 0}}}) {
    World<PrinterDrawer> world;
    world.displaced[marker] = d;
    const Findings findings = identify_printer(world, 5, true);
    expect_places(findings, {world.displaced.begin(), world.displaced.end()});
    EXPECT_LT(std::abs(share_of_deviation(findings.lengths[0], kTrueDistance_m)), 3);
    EXPECT_LT(findings.places[marker].covariance.trace(), std::pow(0.1e-3, 2));
    expect_only_wrong(findings, std::nullopt);
  }
}

TEST(Identify, FindsADisplacedMarkerAcrossAHinge) {
  World<Door> world;
  world.displaced[3] = {0, 0.003, 0};
  Random random{3};
  const auto recording = test::record(world, {}, kMoments, random, {1.5, 3, 0.8});
  const auto findings = identify(Object::of<Door>(), cameras::kXtionVga, recording, {{}, true});
  ASSERT_TRUE(findings);
  expect_places(*findings, {world.displaced.begin(), world.displaced.end()});
}

TEST(Identify, IsAsUncertainOfPlacesAsItSays) {
  double sum = 0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const MarkerPlace& place : identify_printer({}, seed, true).places) {
      for (int i = 0; i < 3; ++i) {
        if (place.covariance(i, i) < 1e-15) continue;  // held
        sum += place.displaced[i] * place.displaced[i] / place.covariance(i, i);
        ++count;
      }
    }
  }
  ASSERT_GT(count, 100);
  // Of 17 numbers a run some 11 are independent: the mean of 6 runs is within 0.4 of 1 in 99 %.
  EXPECT_NEAR(sum / count, 1, 0.4);
}

TEST(Identify, SaysThatAFocalLengthIsWrongAndByHowMuch) {
  World<PrinterDrawer> world;
  world.camera.fx_px *= 1.01, world.camera.fy_px *= 1.01;
  for (const bool places : {false, true}) {
    const Findings findings = identify_printer(world, 2, places);
    expect_only_wrong(findings, Part::focal_length);
    const Judgement& focal = of(findings, Part::focal_length);
    EXPECT_NEAR(focal.error, std::log(1.01), 3 * focal.deviation);
    EXPECT_GT(focal.significance(), 10);
    EXPECT_LT(std::abs(share_of_deviation(findings.lengths[0], kTrueDistance_m)), 3);
  }
}

TEST(Identify, SaysThatALensBendsOtherwise) {
  World<PrinterDrawer> world;
  world.camera.distortion[0] = -0.05;
  const Findings findings = identify_printer(world, 2, true);
  expect_only_wrong(findings, Part::distortion);
  EXPECT_GT(of(findings, Part::distortion).significance(), 50);
  EXPECT_GT(of(findings, Part::distortion).effect_px, 1);
}

TEST(Identify, FindsNothingWrongWithARightCamera) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) expect_only_wrong(identify_printer({}, seed, true), std::nullopt);
}

TEST(Identify, SaysWhatARestingRecordingDoesNotTell) {
  Random random{3};
  const World<PrinterDrawer> world;
  auto q = test::random_view<PrinterDrawer>(vision::CameraModel<double>{world.camera}, {0.5, 1.2, 0.8}, random);
  Recording recording;
  for (int i = 0; i < kMoments; ++i) recording.push_back(world.look(q, random));
  const auto findings =
      identify(Object::of<PrinterDrawer>(), cameras::kXtionVga, recording, {{kSlide, kDistance}, true});
  ASSERT_TRUE(findings);
  EXPECT_TRUE(findings->places.empty());
  EXPECT_FALSE(of(*findings, Part::focal_length).told);
  for (const Judgement& judgement : findings->camera) EXPECT_FALSE(judgement.wrong());
  for (const int i : {kSlide, kDistance}) {
    EXPECT_LT(std::abs(share_of_deviation(findings->lengths[static_cast<std::size_t>(i)], q.joints[i])), 3);
  }
  // Without another view the drawer's place hangs on the focal length.
  EXPECT_GT(findings->lengths[0].deviation, 1e-3);
}

TEST(Identify, WithstandsFalseSightings) {
  Random random{4};
  auto recording = test::record(World<PrinterDrawer>{}, {{kDistance, kTrueDistance_m}}, kMoments, random);
  for (std::size_t i = 0; i < recording.size(); i += 3) recording[i].sightings[i % 6].pixel.x() += 8;
  const auto findings = identify(Object::of<PrinterDrawer>(), cameras::kXtionVga, recording, {{kDistance}, true});
  ASSERT_TRUE(findings);
  EXPECT_GE(findings->num_outliers, kMoments / 3);
  // Huber's loss bounds what each can do, and does not undo it: 6 % of them, all to one side.
  EXPECT_NEAR(findings->lengths[0].value, kTrueDistance_m, 0.1e-3);
  for (const MarkerPlace& place : findings->places) EXPECT_LT(place.displaced.norm(), 0.3e-3);
}

TEST(Identify, NeedsSomeMoments) {
  Random random{4};
  const auto few = test::record(World<PrinterDrawer>{}, {}, static_cast<int>(kLeastMoments) - 1, random);
  EXPECT_FALSE(identify(Object::of<PrinterDrawer>(), cameras::kXtionVga, few, {{}, false}));
}

}  // namespace
}  // namespace articam::identify
