#include "hal/libcamera/camera_choice.hpp"

#include <gtest/gtest.h>

namespace articam {
namespace {

using namespace std::chrono_literals;

/// The problem that a call ends in; empty when there is none.
hal::StartProblem problem_of(const auto& call) {
  try {
    (void)call();
  } catch (const hal::StartProblem& problem) {
    return problem;
  }
  return {Status::ok, {}};
}

bool contains(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

TEST(CameraChoice, FindsACameraByItsIdOrItsPlaceInTheListAndTheFirstByDefault) {
  const std::vector<std::string> ids{"front", "back", "0"};
  EXPECT_EQ(hal::choose_camera(ids, ""), "front");
  EXPECT_EQ(hal::choose_camera(ids, "back"), "back");
  EXPECT_EQ(hal::choose_camera(ids, "1"), "back");
  EXPECT_EQ(hal::choose_camera(ids, "0"), "0");  // an id goes before a number
}

TEST(CameraChoice, AnswersACameraThatDoesNotExistWithTheListOfThoseThatDo) {
  for (const char* wanted : {"side", "2", "1x", "-1"}) {
    const auto problem = problem_of([&] { return hal::choose_camera({"front", "back"}, wanted); });
    EXPECT_EQ(problem.status, Status::no_device);
    EXPECT_TRUE(contains(problem.reason, wanted)) << problem.reason;
    EXPECT_TRUE(contains(problem.reason, "0: front\n  1: back")) << problem.reason;
  }
  const auto problem = problem_of([] { return hal::choose_camera({}, "front"); });
  EXPECT_EQ(problem.status, Status::no_device);
  EXPECT_TRUE(contains(problem.reason, "finds no camera"));
}

TEST(CameraChoice, FixesExposureAndGainWithinWhatTheCameraCanDoAndRefusesElse) {
  const hal::LibcameraOptions options{.exposure = 4000us, .gain = 2.0};
  hal::Abilities abilities;
  const auto problem = [&] { return problem_of([&] { return hal::choose_controls(abilities, options); }); };
  EXPECT_TRUE(contains(problem().reason, "cannot fix its exposure"));
  abilities.exposure_us = {100, 3000};
  EXPECT_TRUE(contains(problem().reason, "outside"));
  abilities.exposure_us = {100, 30000};
  EXPECT_TRUE(contains(problem().reason, "cannot fix its gain"));
  EXPECT_EQ(problem().status, Status::bad_argument);
  abilities.gain = {1, 8};
  const auto controls = hal::choose_controls(abilities, options);
  EXPECT_EQ(controls.exposure_us, 4000);
  EXPECT_EQ(controls.gain, 2.0f);
}

TEST(CameraChoice, LeavesExposureAndGainAutomaticUnlessTold) {
  const hal::Abilities able{{}, hal::ControlRange{100, 30000}, hal::ControlRange{1, 8}, {}};
  const auto controls = hal::choose_controls(able, {});
  EXPECT_EQ(controls.exposure_us, std::nullopt);
  EXPECT_EQ(controls.gain, std::nullopt);
}

TEST(CameraChoice, SetsThePeriodOnlyWhereTheCameraCan) {
  const hal::LibcameraOptions options{.period = 33333us};
  EXPECT_EQ(hal::choose_controls({}, options).period_us, std::nullopt);
  EXPECT_EQ(hal::choose_controls({{}, {}, {}, hal::ControlRange{8000, 1e6}}, options).period_us, 33333);
}

}  // namespace
}  // namespace articam
