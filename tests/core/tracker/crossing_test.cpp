#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/tracker/tracker.hpp"
#include "host_sim/world/object_state.hpp"
#include "host_sim/world/renderer.hpp"
#include "tests/support/random_views.hpp"

// Marks of one object pass each other in the image: rendered frames (f = 525 px, blur 0.7 px, noise 4 grey levels,
// clutter), 30 a second, through the whole tracker. A mark on its card hides another one while their cards overlap.
namespace articam::tracker {

/// A board with a mark in each corner and two slides along it: the far one on the board, the near one 4 cm before it.
/// Later rows are painted over earlier ones, so the near slide comes last.
struct Slides {
  using enum model::JointKind;
  using enum model::MarkerKind;
  static constexpr std::string_view kName = "slides";
  static constexpr std::array<model::JointRow, 2> kJoints{{
      {"far_slide", prismatic, -1, {1, 0, 0}, {0, 0, 0}, {1, 0, 0, 0}, -0.2, 0.2},
      {"near_slide", prismatic, -1, {1, 0, 0}, {0, 0, -0.04}, {1, 0, 0, 0}, -0.2, 0.2},
  }};
  static constexpr std::array<model::MarkerRow, 6> kMarkers{{
      {"corner_0", ring, -1, {-0.25, -0.16, 0}, {0, 0, -1}, 0.05, 0.02},
      {"corner_1", ring, -1, {0.25, -0.16, 0}, {0, 0, -1}, 0.05, 0.02},
      {"corner_2", ring, -1, {0.18, 0.16, 0}, {0, 0, -1}, 0.05, 0.02},
      {"corner_3", ring, -1, {-0.25, 0.16, 0}, {0, 0, -1}, 0.05, 0.02},
      {"far_ring", ring, 0, {0, 0, 0}, {0, 0, -1}, 0.05, 0.02},
      {"near_ring", ring, 1, {0, 0, 0}, {0, 0, -1}, 0.05, 0.02},
  }};
  static constexpr bool kHasQ0 = false;
  static constexpr std::array<double, 9> kQ0{0, 0, 0, 1, 0, 0, 0, 0, 0};
};

/// The same with a near ring of 4 cm.
struct UnevenSlides : Slides {
  static constexpr std::array<model::MarkerRow, 6> kMarkers = [] {
    auto markers = Slides::kMarkers;
    markers[5].outer_diameter_m = 0.04, markers[5].inner_diameter_m = 0.016;
    return markers;
  }();
};

namespace {

constexpr CameraParameters kCamera{
    .width_px = 640, .height_px = 480, .fx_px = 525, .fy_px = 525, .cx_px = 319.5, .cy_px = 239.5};

/// How the slides stand and the board lies at a time.
using Motion = model::Configuration<Slides, double> (*)(double t_s);

model::Configuration<Slides, double> board(double far_m, double near_m) {
  return model::from_numbers<Slides, double>({0.01, -0.02, 0.8, 0.995, 0.06, 0.05, 0.03, far_m, near_m}).value();
}

model::Configuration<Slides, double> one_passes(double t_s) { return board(0.0, 0.15 - 0.15 * t_s); }
model::Configuration<Slides, double> both_pass(double t_s) { return board(-0.14 + 0.14 * t_s, 0.14 - 0.14 * t_s); }
model::Configuration<Slides, double> they_turn_back(double t_s) {
  const double swing_m = 0.13 * math::sin_cos(std::numbers::pi / 2 * (1 + t_s)).sin;
  return board(-swing_m, swing_m);
}
model::Configuration<Slides, double> both_pass_on_a_moving_board(double t_s) {
  auto q = both_pass(t_s);
  q.T_cam_obj.t.x() += 0.06 * math::sin_cos(2 * std::numbers::pi * t_s).sin;
  q.T_cam_obj.t.y() += 0.03 * math::sin_cos(3 * std::numbers::pi * t_s).sin;
  return q;
}
model::Configuration<Slides, double> one_starts_when_it_is_hidden(double t_s) {
  auto q = one_passes(t_s);
  q.joints[0] = t_s < 1 ? 0.0 : 0.2 * (t_s - 1);
  return q;
}

struct Outcome {
  int frames{}, tracking{}, untracked{}, swaps{}, hidden{};
};

/// Two seconds of a motion. A match farther than 3 px from its own marker's true image is another's.
template <class M>
Outcome watch(Motion motion) {
  const auto tracker = std::make_unique<Tracker<M, double>>(kCamera);
  sim::Renderer renderer{kCamera, {}};
  std::vector<std::uint8_t> pixels;
  Outcome outcome;
  const auto start = motion(0);
  tracker->set_start({start.T_cam_obj, start.joints});
  for (int k = 0; k <= 60; ++k) {
    const auto truth = motion(k / 30.0);
    model::Configuration<M, double> q{truth.T_cam_obj, truth.joints};
    renderer.render(sim::scene_markers<M>(q), static_cast<std::uint64_t>(k), pixels);
    const auto estimate =
        tracker->step({pixels.data(), kCamera.width_px, kCamera.height_px, kCamera.width_px}, from_seconds(k / 30.0));
    ++outcome.frames;
    outcome.tracking += estimate.status == TrackingStatus::tracking ? 1 : 0;
    outcome.untracked += estimate.valid ? 0 : 1;
    outcome.hidden += tracker->detections().size() < 6 ? 1 : 0;
    const auto features = predict_features<M, double>(q, tracker->camera());
    for (std::size_t m = 0; m < features.size(); ++m) {
      const auto& match = tracker->matches()[m];
      if (match.matched && (match.pixel - features[m].pixel).norm() > 3) ++outcome.swaps;
    }
  }
  return outcome;
}

struct Meeting {
  const char* name;
  Motion motion;
};

class Crossing : public testing::TestWithParam<Meeting> {};

template <class M>
void expect_names_kept(Motion motion) {
  const Outcome outcome = watch<M>(motion);
  EXPECT_EQ(outcome.swaps, 0);
  EXPECT_EQ(outcome.untracked, 0);
  EXPECT_GT(outcome.hidden, 3) << "the marks have not met";
  // Only while a mark is hidden is its slide not observed.
  EXPECT_GE(outcome.tracking, outcome.frames - outcome.hidden - 2);
}

TEST_P(Crossing, LeavesEveryMarkerItsOwnMark) { expect_names_kept<Slides>(GetParam().motion); }
TEST_P(Crossing, LeavesMarkersOfDifferentSizeTheirOwnMarks) { expect_names_kept<UnevenSlides>(GetParam().motion); }

INSTANTIATE_TEST_SUITE_P(Of, Crossing,
                         testing::Values(Meeting{"OneThatPasses", one_passes}, Meeting{"BothThatPass", both_pass},
                                         Meeting{"TwoThatTurnBack", they_turn_back},
                                         Meeting{"BothOnAMovingBoard", both_pass_on_a_moving_board},
                                         Meeting{"OneThatStartsHidden", one_starts_when_it_is_hidden}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace articam::tracker
