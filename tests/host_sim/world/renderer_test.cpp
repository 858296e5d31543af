#include "host_sim/world/renderer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math/so3.hpp"
#include "core/vision/imaged_circle.hpp"
#include "host_sim/scenarios/paper.hpp"
#include "host_sim/world/imaged_disc.hpp"

namespace articam::sim {
namespace {

constexpr RenderOptions kClean{.blur_px = 0, .noise_grey = 0, .clutter = false};

std::vector<std::uint8_t> render(const std::vector<SceneMarker>& markers, const RenderOptions& options,
                                 const CameraParameters& camera = PaperScenario::camera(), std::uint64_t frame = 0) {
  std::vector<std::uint8_t> pixels;
  Renderer{camera, options}.render(markers, frame, pixels);
  return pixels;
}

std::vector<SceneMarker> paper_scene() { return scene_markers<PaperScenario::Model>(PaperScenario::at(0).q); }

/// Darkness-weighted mean of the pixels on the marker's card.
Vec<double, 2> centroid(const std::vector<std::uint8_t>& pixels, const SceneMarker& marker,
                        const CameraParameters& camera) {
  const vision::CameraModel<double> model{camera};
  const ImagedDisc card{marker.centre_cam_m, marker.normal_cam, 1.2 * marker.outer_radius_m};
  double sum = 0;
  Vec<double, 2> weighted = Vec<double, 2>::Zero();
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      const auto ray = model.unproject({u, v});
      if (!ray.ok() || card.side(ray.value().homogeneous()) > 0) continue;
      const double dark = 215.0 - pixels[static_cast<std::size_t>(v * camera.width_px + u)];
      sum += dark;
      weighted += dark * Vec<double, 2>{u, v};
    }
  }
  return weighted / sum;
}

// Rounding 160 edge pixels to whole greys moves the centroid of a mark of 2,000 pixels by 2e-4 px; blur adds rounding.
constexpr double kCentroidTolerance_px = 2e-3;

TEST(Renderer, PutsTheCentroidOfADotAtTheCentreOfItsImagedCircle) {
  for (const double blur_px : {0.0, 0.7}) {
    RenderOptions options = kClean;
    options.blur_px = blur_px;
    for (SceneMarker marker : paper_scene()) {
      marker.kind = model::MarkerKind::dot_dark_on_light;
      const auto s = vision::imaged_centre<double>({marker.centre_cam_m, marker.normal_cam, marker.outer_radius_m});
      ASSERT_TRUE(s.ok());
      const CameraParameters camera = PaperScenario::camera();
      const Vec<double, 2> expected = vision::CameraModel<double>{camera}.project(s.value());
      EXPECT_LT((centroid(render({marker}, options), marker, camera) - expected).norm(), kCentroidTolerance_px);
    }
  }
}

TEST(Renderer, SeesThroughTheLensDistortion) {
  CameraParameters camera = PaperScenario::camera();
  camera.distortion = {-0.3, 0.1, 0.001, -0.002, 0};
  SceneMarker marker = paper_scene()[0];
  marker.kind = model::MarkerKind::dot_dark_on_light;
  marker.outer_radius_m = 0.006;  // small: over its image the lens is nearly affine
  const auto s = vision::imaged_centre<double>({marker.centre_cam_m, marker.normal_cam, marker.outer_radius_m});
  ASSERT_TRUE(s.ok());
  const Vec<double, 2> expected = vision::CameraModel<double>{camera}.project(s.value());
  // Over 5 px of radius the curvature of this lens moves the centroid by 0.01 px.
  EXPECT_LT((centroid(render({marker}, kClean, camera), marker, camera) - expected).norm(), 0.02);
}

TEST(Renderer, MakesTheSameBytesFromTheSameSeedInEveryCompiler) {
  const auto pixels = render(paper_scene(), {});
  EXPECT_EQ(pixels, render(paper_scene(), {}));
  EXPECT_NE(pixels, render(paper_scene(), {}, PaperScenario::camera(), 1)) << "noise is new in every frame";
  EXPECT_NE(pixels, render(paper_scene(), {.seed = 2}));
  std::uint64_t fnv1a = 0xcbf29ce484222325U;
  for (const std::uint8_t pixel : pixels) fnv1a = (fnv1a ^ pixel) * 0x100000001b3U;
  EXPECT_EQ(fnv1a, 7650178112221720978u)
      << "the same constant for g++ and clang++; a change of the renderer changes it";
}

TEST(Renderer, MakesAFrameThatDoesNotDependOnEarlierOnes) {
  Renderer renderer{PaperScenario::camera(), {}};
  std::vector<std::uint8_t> pixels;
  renderer.render(scene_markers<PaperScenario::Model>(PaperScenario::at(6).q), 4, pixels);
  renderer.render(paper_scene(), 0, pixels);
  EXPECT_EQ(pixels, render(paper_scene(), {}));
}

TEST(Renderer, LeavesOutMarksSeenFromBehindPointsAndMarksBehindTheCamera) {
  SceneMarker behind = paper_scene()[0], point = behind, turned = behind;
  behind.centre_cam_m.z() = -0.5;
  point.kind = model::MarkerKind::point;
  turned.normal_cam = -turned.normal_cam;
  EXPECT_EQ(render({behind, point, turned}, kClean), render({}, kClean));
}

TEST(Renderer, DrawsMarksThatAreCutByTheBorder) {
  SceneMarker marker = paper_scene()[0];
  for (const double x_m : {-0.43, 0.43, -3.0, 3.0}) {
    marker.centre_cam_m = {x_m, 0, 0.7};
    marker.normal_cam = {0, 0, -1};
    const auto pixels = render({marker}, kClean);
    const bool inside = std::abs(x_m) < 1;
    EXPECT_EQ(*std::min_element(pixels.begin(), pixels.end()) < 100, inside) << x_m;
  }
}

Vec<double, 2> imaged_centre(const SceneMarker& marker, const CameraParameters& camera) {
  const auto s = vision::imaged_centre<double>({marker.centre_cam_m, marker.normal_cam, marker.outer_radius_m});
  return vision::CameraModel<double>{camera}.project(s.value());
}

/// A small dot that moves so far while it is exposed, on a card that keeps what is behind out of its way.
SceneMarker moving_dot(const Vec<double, 2>& way_px) {
  SceneMarker marker = paper_scene()[0];
  marker.kind = model::MarkerKind::dot_dark_on_light;
  marker.outer_radius_m *= 0.5;
  const double px_per_mps = 525 / marker.centre_cam_m.z() * kClean.exposure_time_s;
  marker.velocity = {way_px.x() / px_per_mps, way_px.y() / px_per_mps, 0};
  return marker;
}

TEST(Renderer, LeavesTheCentroidWhereAMarkIsHalfWayThroughItsMotion) {
  const SceneMarker marker = moving_dot({2, -1.2});
  const CameraParameters camera = PaperScenario::camera();
  SceneMarker still = marker;
  still.velocity.setZero();
  EXPECT_NE(render({still}, kClean), render({marker}, kClean));
  const Vec<double, 2> centre = centroid(render({marker}, kClean), marker, camera);
  EXPECT_LT((centre - imaged_centre(marker, camera)).norm(), kCentroidTolerance_px);
}

TEST(Renderer, SmearsAMarkAlongItsOwnWay) {
  constexpr double kWay_px = 8;
  const SceneMarker marker = moving_dot({kWay_px, 0});
  SceneMarker still = marker;
  still.velocity.setZero();
  const CameraParameters camera = PaperScenario::camera();
  const Vec<double, 2> c = imaged_centre(marker, camera);
  const auto wall = render({}, kClean);
  double sum = 0;
  const auto moments = [&](const SceneMarker& drawn) {
    const auto pixels = render({drawn}, kClean);
    Vec<double, 2> squares = Vec<double, 2>::Zero();
    sum = 0;
    for (int v = 0; v < camera.height_px; ++v) {
      for (int u = 0; u < camera.width_px; ++u) {
        const auto i = static_cast<std::size_t>(v * camera.width_px + u);
        sum += wall[i] - pixels[i];
        squares += (wall[i] - pixels[i]) * (Vec<double, 2>{u, v} - c).cwiseAbs2();
      }
    }
    return squares;
  };
  // Along its way the variance grows by a twelfth of its square, across not. Dot and card nearly balance in the sum, so
  // that whole greys on some 200 edge pixels move it by some per cent.
  const Vec<double, 2> grown = (moments(marker) - moments(still)) / sum;
  EXPECT_NEAR(grown.x(), kWay_px * kWay_px / 12, 0.1 * kWay_px * kWay_px / 12);
  EXPECT_NEAR(grown.y(), 0, 0.15);
}

TEST(Renderer, ShowsEveryRowAtItsOwnTime) {
  CameraParameters rolling = PaperScenario::camera();
  rolling.readout_time_s = 0.02;
  RenderOptions instant = kClean;
  instant.exposure_time_s = 0;
  SceneMarker marker = moving_dot({0, 0});
  marker.velocity = {0.1, 0.05, -0.1};
  marker.angular_velocity = {0.4, 0.2, 0};
  const auto pixels = render({marker}, instant, rolling);
  const int middle = static_cast<int>(imaged_centre(marker, rolling).y());
  for (const int v : {middle - 6, middle, middle + 6}) {
    const double t_s = 0.02 * v / 479;
    SceneMarker then = marker;
    then.centre_cam_m += t_s * marker.velocity;
    then.normal_cam = math::exp_so3<double>(t_s * marker.angular_velocity) * marker.normal_cam;
    then.velocity = then.angular_velocity = Vec<double, 3>::Zero();
    const auto still = render({then}, instant);
    const auto row = static_cast<std::ptrdiff_t>(v) * 640;
    EXPECT_TRUE(std::equal(pixels.begin() + row, pixels.begin() + row + 640, still.begin() + row)) << "row " << v;
  }
  EXPECT_NE(pixels, render({marker}, instant));
}

TEST(Renderer, TakesNewLightAsIfItHadAlwaysBeenSo) {
  Renderer renderer{PaperScenario::camera(), {}};
  std::vector<std::uint8_t> pixels;
  for (const double exposure : {0.5, 1.3, 1.0}) {
    renderer.set_exposure(exposure);
    renderer.render(paper_scene(), 3, pixels);
    EXPECT_EQ(pixels, render(paper_scene(), {.exposure = exposure}, PaperScenario::camera(), 3)) << exposure;
  }
}

TEST(Renderer, PaintsLimbsOverMarkers) {
  const auto markers = paper_scene();
  const Vec<double, 3> before = 0.8 * markers[0].centre_cam_m;
  const Limb limb{before - Vec<double, 3>{1, 0, 0}, before + Vec<double, 3>{1, 0, 0}, 0.05};
  std::vector<std::uint8_t> hidden, bare;
  Renderer renderer{PaperScenario::camera(), kClean};
  renderer.render({&markers[0], 1}, 0, hidden, {&limb, 1});
  renderer.render({}, 0, bare, {&limb, 1});
  EXPECT_EQ(hidden, bare) << "nothing of the marker is seen";
  EXPECT_NE(bare, render({}, kClean));
}

TEST(Renderer, DarkensTowardsTheRightByTheLightGradient) {
  RenderOptions options = kClean;
  options.light_gradient = 8;
  const auto pixels = render({}, options);
  EXPECT_NEAR(static_cast<double>(pixels.front()) / pixels[639], 8, 0.4) << "whole greys: 130 against 16";
}

}  // namespace
}  // namespace articam::sim
