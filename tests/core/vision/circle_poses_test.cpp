#include "core/vision/circle_poses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/vision/lens_ellipse.hpp"
#include "tests/core/vision/circle_scene.hpp"

namespace articam {
namespace {

using vision::Circle;
using vision::PlaneEllipse;

CameraParameters pinhole() {
  CameraParameters p;
  p.width_px = 640, p.height_px = 480, p.fx_px = 525, p.fy_px = 500, p.cx_px = 319.5, p.cy_px = 239.5;
  return p;
}
const vision::CameraModel<double> kPinhole{pinhole()};

double distance(const Circle<double>& a, const Circle<double>& b) {
  return std::max((a.centre - b.centre).norm(), (a.normal - b.normal).norm());
}

TEST(CirclePoses, HoldTheTrueCircleAmongTheTwoAndBothHaveTheSameImage) {
  test::Random random{21};
  for (int i = 0; i < 2000; ++i) {
    const auto truth = test::circle_in_view(random);
    const auto image = test::image_of(truth);
    const auto poses = vision::circle_poses(image, truth.radius);
    ASSERT_TRUE(poses.ok()) << i;
    const auto& [one, other] = poses.value().solutions;
    const bool first = distance(one, truth) < distance(other, truth);
    // A tilt is known by its square only: image_of()'s rounding, 1e-16 / (r / z)^2, counts more near 0.
    EXPECT_LT(distance(first ? one : other, truth), 1e-9) << i;
    const auto mirrored = test::image_of(first ? other : one);
    EXPECT_LT((mirrored.centre - image.centre).norm(), 1e-11) << i;
    EXPECT_LT((mirrored.M - image.M).norm(), 1e-11) << i;
    EXPECT_NEAR(one.centre.norm(), other.centre.norm(), 1e-14);
  }
}

TEST(CirclePoses, CoincideWhereTheCircleFacesTheCameraAlongItsOwnRay) {
  const Vec<double, 3> centre{0.2, -0.1, 0.8};
  const auto poses = vision::circle_poses(test::image_of({centre, -centre.normalized(), 0.025}), 0.025);
  ASSERT_TRUE(poses.ok());
  for (const auto& solution : poses.value().solutions) {
    EXPECT_LT((solution.centre - centre).norm(), 1e-9);
    EXPECT_LT((solution.normal + centre.normalized()).norm(), 1e-6);  // the square root of rounding, 1e-12 of B / A
  }
}

TEST(CirclePoses, AreFoundInFloatToTheMicrometreWhereTheTiltIsKnown) {
  test::Random random{22};
  for (int i = 0; i < 2000; ++i) {
    const auto truth = test::circle_in_view(random);
    const auto image = test::image_of(truth);
    const PlaneEllipse<float> in_float{image.centre.cast<float>(), image.M.cast<float>()};
    const auto poses = vision::circle_poses(in_float, static_cast<float>(truth.radius));
    ASSERT_TRUE(poses.ok()) << i;
    const double range = truth.centre.norm();
    // Few units of 6e-8 in A, all of the range hangs on it; the tilt's share of it is less.
    EXPECT_NEAR(poses.value().range_m(), range, 1e-6 * range) << i;
    const double cosine = -truth.normal.dot(truth.centre) / range;
    if (cosine > 0.95) continue;
    double nearest = 1;
    for (const auto& s : poses.value().solutions) {
      nearest = std::min(nearest, (s.normal.cast<double>() - truth.normal).norm());
    }
    EXPECT_LT(nearest, 1e-5) << i;
  }
}

TEST(CirclePoses, AreAsExactThroughALens) {
  auto p = pinhole();
  p.distortion_model = DistortionModel::equidistant;
  p.distortion = {-0.02, 0.01, -0.003, 0.001};
  const vision::CameraModel<double> camera{p};
  test::Random random{24};
  for (int i = 0; i < 500; ++i) {
    const auto truth = test::circle_in_view(random);
    const auto seen = vision::distorted_ellipse(test::image_of(truth), camera);
    ASSERT_TRUE(seen.ok()) << i;
    const auto image = vision::undistorted_ellipse(seen.value(), camera);
    ASSERT_TRUE(image.ok()) << i;
    const auto poses = vision::circle_poses(image.value(), truth.radius);
    ASSERT_TRUE(poses.ok()) << i;
    const auto& [one, other] = poses.value().solutions;
    // lens_ellipse's 1e-9 px against a semi-minor axis of a few tenths of a pixel at the least
    EXPECT_LT(std::min((one.centre - truth.centre).norm(), (other.centre - truth.centre).norm()), 1e-8) << i;
  }
}

TEST(CirclePoses, RefuseWhatIsNoEllipseNoRadiusAndNoNumber) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  const auto image = test::image_of({{0.1, 0, 0.7}, {0, 0, -1}, 0.025});
  ASSERT_TRUE(vision::circle_poses(image, 0.025).ok());
  for (const double radius : {0.0, -0.025, kNaN, kInf}) {
    EXPECT_EQ(vision::circle_poses(image, radius).status(), Status::bad_argument) << radius;
  }
  for (const double bad : {0.0, -1.0, kNaN, kInf}) {
    auto flat = image;
    flat.M(0, 0) = bad;
    EXPECT_EQ(vision::circle_poses(flat, 0.025).status(), Status::bad_argument) << bad;
    flat = image;
    flat.M(1, 1) = bad;
    EXPECT_EQ(vision::circle_poses(flat, 0.025).status(), Status::bad_argument) << bad;
  }
  auto nowhere = image;
  nowhere.centre.x() = kNaN;
  EXPECT_EQ(vision::circle_poses(nowhere, 0.025).status(), Status::bad_argument);
  EXPECT_EQ(vision::circle_poses(image, 1e-5).status(), Status::behind_camera);  // nearer than kMinDepth_m
  EXPECT_EQ(vision::circle_poses<double>({}, 0.025, kPinhole).status(), Status::bad_argument);
}

TEST(CirclePoses, FromPixelsAreAsExactAsTheirFixedPoint) {
  test::Random random{23};
  for (int i = 0; i < 200; ++i) {
    const auto truth = test::circle_in_view(random);
    auto image = test::image_of(truth);
    const double semi_minor_px = 500 * image.M(0, 0) * image.M(1, 1) / vision::semi_major(image);
    image.centre = kPinhole.project(image.centre);
    image.M = vision::lower_triangular<double>(Vec<double, 2>{525, 500}.asDiagonal() * image.M);
    const auto poses = vision::circle_poses(vision::to_q16(image), truth.radius, kPinhole);
    ASSERT_TRUE(poses.ok());
    // Half of 2^-16 px in each length, against the smaller one.
    EXPECT_NEAR(poses.value().range_m() / truth.centre.norm(), 1, 2e-5 / semi_minor_px) << i;
  }
}

}  // namespace
}  // namespace articam
