#include "core/vision/detector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tests/core/vision/detector_score.hpp"

// Rendered rings of 5 cm, f = 525 px, blur 0.7 px, noise 4 grey levels, cluttered; errors against the true image
// ellipse.
namespace articam::vision {
namespace {

struct Cell {
  model::MarkerKind kind;
  double diameter_px, tilt_deg;
  double light_gradient;
  double max_rms_px;      ///< of the centre, 2-D
  double max_axis_error;  ///< of the major axis's mean, relative
  double min_found;
  double blur_px = 0.7;
};

class DetectorAccuracy : public testing::TestWithParam<Cell> {};

TEST_P(DetectorAccuracy, IsAFewHundredthsOfAPixelAndTheVarianceSaysSo) {
  const Cell cell = GetParam();
  std::mt19937 random(7);
  sim::Renderer renderer(test::kVga, {.blur_px = cell.blur_px, .light_gradient = cell.light_gradient});
  DetectorOptions options{.camera = pinhole_of(test::kVga)};
  options.rings = cell.kind == model::MarkerKind::ring;
  options.dots_light_on_dark = cell.kind == model::MarkerKind::dot_light_on_dark;
  options.dots_dark_on_light = cell.kind == model::MarkerKind::dot_dark_on_light;
  const auto detector = std::make_unique<Detector>(options);
  std::vector<std::uint8_t> pixels;
  test::DetectorScore score;
  for (std::uint64_t i_frame = 0; i_frame < 20; ++i_frame) {
    const auto markers =
        test::grid_of_markers(cell.kind, 3, 2, cell.diameter_px, cell.tilt_deg * std::numbers::pi / 180, random);
    renderer.render(markers, i_frame, pixels);
    Detections found;
    ASSERT_EQ(detector->detect(test::view_of(pixels), found), Status::ok);
    EXPECT_FALSE(detector->overloaded());
    score.add(markers, found);
  }
  ASSERT_GT(score.found, 0);
  EXPECT_GE(score.share_found(), cell.min_found);
  if (cell.kind == model::MarkerKind::ring) {
    EXPECT_EQ(score.surplus, 0);  // the clutter holds discs, and annuli of other ratios
  }
  EXPECT_LT(score.rms_px(), cell.max_rms_px);
  EXPECT_LT(std::abs(score.mean_major_error()), cell.max_axis_error);
  EXPECT_GT(score.normalised_variance(), 0.7);  // of 120 marks it is known to 0.09
  EXPECT_LT(score.normalised_variance(), 1.35);
}

// Bounds are what was measured (over 150 marks) and a third: a worse fit is seen, another random draw is not.
constexpr auto kRing = model::MarkerKind::ring, kLight = model::MarkerKind::dot_light_on_dark,
               kDark = model::MarkerKind::dot_dark_on_light;
// clang-format off
INSTANTIATE_TEST_SUITE_P(Cells, DetectorAccuracy, testing::Values(
  //   kind  diameter tilt light   rms   axis  found
  Cell{kRing,  72,     0,   1,   0.0085, 0.002, 1.00},
  Cell{kRing,  31,     0,   1,   0.0100, 0.003, 1.00},
  Cell{kRing,  20,     0,   1,   0.0117, 0.003, 0.99},
  Cell{kRing,  15,     0,   1,   0.0140, 0.003, 0.99},
  Cell{kRing,  12,     0,   1,   0.0147, 0.006, 0.97},
  Cell{kRing,  31,    40,   1,   0.0100, 0.003, 1.00},
  Cell{kRing,  15,    40,   1,   0.0150, 0.003, 0.99},
  Cell{kRing,  31,    60,   1,   0.0133, 0.004, 0.99},
  Cell{kRing,  20,    60,   1,   0.0157, 0.004, 0.99},
  Cell{kRing,  15,    60,   1,   0.0204, 0.006, 0.99},
  Cell{kRing,  31,    60,   1,   0.0235, 0.012, 0.99, 2.0},
  Cell{kRing,  12,    60,   1,   0.0260, 0.012, 0.95},
  Cell{kRing,  72,    40,   8,   0.0170, 0.002, 1.00},
  Cell{kRing,  31,    30,   8,   0.0255, 0.003, 1.00},
  Cell{kRing,  20,    20,   8,   0.0290, 0.003, 1.00},
  Cell{kLight, 31,    40,   1,   0.014, 0.004, 0.99},
  Cell{kLight, 12,     0,   1,   0.027, 0.008, 0.98},
  Cell{kDark,  31,    40,   1,   0.014, 0.004, 0.99},
  Cell{kDark,  12,     0,   1,   0.027, 0.008, 0.98}),
  [](const testing::TestParamInfo<Cell>& cell) { return "Cell" + std::to_string(cell.index); });
// clang-format on

// Light that grows by g a radius makes a pixel at r radii 1 + g r times as bright, wherever r = 1 the mark's edge is:
// a fit that takes all of a ray for as bright as its edge is off by a share of g, which no further frame averages out.
TEST(DetectorAccuracy, IsNotMovedByLightThatGrowsAcrossAMark) {
  const auto detector = std::make_unique<Detector>();
  std::vector<std::uint8_t> pixels;
  for (const double tilt_deg : {0.0, 45.0, 60.0}) {
    std::mt19937 random(7);
    sim::Renderer renderer(test::kVga, {.noise_grey = 0.5, .clutter = false, .light_gradient = 8});
    test::DetectorScore score;
    for (std::uint64_t i_frame = 0; i_frame < 10; ++i_frame) {
      const auto markers = test::grid_of_markers(kRing, 3, 2, 72, tilt_deg * std::numbers::pi / 180, random);
      renderer.render(markers, i_frame, pixels);
      Detections found;
      ASSERT_EQ(detector->detect(test::view_of(pixels), found), Status::ok);
      score.add(markers, found);
    }
    EXPECT_EQ(score.found, score.shown);
    EXPECT_LT(score.rms_px(), 0.010) << "at " << tilt_deg << " deg";
  }
}

// Blur moves an edge inwards by its variance over its diameter, 0.1 to 1.3 % here; what is left of that is a bias.
TEST(DetectorAccuracy, KnowsTheMajorAxisToThreeThousandthsUnderBlurUpToAPixelAndTiltUpTo40Degrees) {
  const auto detector = std::make_unique<Detector>();
  std::vector<std::uint8_t> pixels;
  for (const double blur_px : {0.7, 1.0}) {
    for (const double diameter_px : {15.0, 20.0, 31.0}) {
      for (const double tilt_deg : {0.0, 20.0, 40.0}) {
        std::mt19937 random(7);
        sim::Renderer renderer(test::kVga, {.blur_px = blur_px, .clutter = false});
        test::DetectorScore score;
        for (std::uint64_t i_frame = 0; i_frame < 10; ++i_frame) {
          const auto markers =
              test::grid_of_markers(kRing, 4, 3, diameter_px, tilt_deg * std::numbers::pi / 180, random);
          renderer.render(markers, i_frame, pixels);
          Detections found;
          ASSERT_EQ(detector->detect(test::view_of(pixels), found), Status::ok);
          score.add(markers, found);
        }
        EXPECT_EQ(score.found, score.shown);
        EXPECT_LT(std::abs(score.mean_major_error()), 0.003)
            << "blur " << blur_px << ", " << diameter_px << " px at " << tilt_deg << " deg";
      }
    }
  }
}

// Motion by four fifths of the hole's diameter leaves the chords along it without ends.
TEST(DetectorAccuracy, FindsRingsOf20PixelsThatMoveBy8InAnyDirectionWhileExposed) {
  const auto detector = std::make_unique<Detector>();
  std::vector<std::uint8_t> pixels;
  test::DetectorScore score;
  std::mt19937 random(7);
  constexpr int kDirections = 24;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = std::numbers::pi * i / kDirections;
    auto markers = test::grid_of_markers(kRing, 4, 3, 20, std::numbers::pi / 6, random);
    test::set_moving(markers, {8 * std::cos(angle), 8 * std::sin(angle)});
    sim::Renderer renderer(test::kVga, {});
    renderer.render(markers, static_cast<std::uint64_t>(i), pixels);
    Detections found;
    ASSERT_EQ(detector->detect(test::view_of(pixels), found), Status::ok);
    score.add(markers, found);
  }
  EXPECT_GE(score.share_found(), 0.96);  // asked for: 0.95
  EXPECT_EQ(score.surplus, 0);
}

// Small holes are blurred most: annuli just outside 0.32 to 0.50, of 12 to 22 px, are told apart from rings of 0.41.
TEST(DetectorAccuracy, TakesNoSmallAnnulusOfAnotherRatioForARing) {
  std::mt19937 random(3);
  const auto between = [&random](double a, double b) {
    return a + (b - a) * static_cast<double>(random()) / 4294967296.0;
  };
  const auto detector = std::make_unique<Detector>();
  std::vector<std::uint8_t> pixels;
  for (std::uint64_t i_frame = 0; i_frame < 40; ++i_frame) {
    sim::Renderer renderer(test::kVga, {.seed = i_frame + 1});
    auto markers = test::grid_of_markers(kRing, 4, 3, between(12, 22), between(0, 1.1), random);
    for (sim::SceneMarker& marker : markers) {
      marker.inner_radius_m = marker.outer_radius_m * (random() % 2 == 0 ? between(0.26, 0.32) : between(0.50, 0.56));
    }
    renderer.render(markers, 0, pixels);
    Detections found;
    ASSERT_EQ(detector->detect(test::view_of(pixels), found), Status::ok);
    EXPECT_EQ(found.size(), 0u) << "frame " << i_frame;
  }
}

TEST(DetectorAccuracy, HoldsForADotOfHalfTheFrameAndOneOfSevenPixels) {
  std::mt19937 random(2);
  sim::Renderer renderer(test::kVga, {.clutter = false});
  std::vector<std::uint8_t> pixels;
  const auto detector = std::make_unique<Detector>(
      DetectorOptions{.rings = false, .dots_light_on_dark = true, .dots_dark_on_light = true});
  for (const double diameter_px : {240.0, 7.0}) {
    for (const auto kind : {kLight, kDark}) {
      const auto markers = test::grid_of_markers(kind, 1, 1, diameter_px, 0.3, random);
      renderer.render(markers, 0, pixels);
      Detections found;
      ASSERT_EQ(detector->detect(test::view_of(pixels), found), Status::ok);
      const test::TrueEllipse truth = test::imaged(markers[0], test::kRadius_m);
      bool there = false;
      for (const Detection& mark : found) {
        const test::TrueEllipse seen = test::measured(mark.outer);
        there |= std::hypot(seen.u_px - truth.u_px, seen.v_px - truth.v_px) < 0.15;  // three sigma of the small dot
      }
      EXPECT_TRUE(there) << diameter_px << " px at " << truth.u_px << ", " << truth.v_px;
    }
  }
}

}  // namespace
}  // namespace articam::vision
