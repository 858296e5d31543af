#include "core/vision/ring_position.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/vision/imaged_circle.hpp"

namespace articam {
namespace {

vision::CameraModel<double> camera() {
  CameraParameters p;
  p.width_px = 640, p.height_px = 480, p.fx_px = 525, p.fy_px = 500, p.cx_px = 319.5, p.cy_px = 239.5;
  return vision::CameraModel<double>{p};
}

std::int32_t q16(double x) { return static_cast<std::int32_t>(std::lround(x * 65536)); }

/// The image of a circle in the pinhole of `camera()`, from its dual conic  c c^T - r^2 (I - n n^T).
vision::Ellipse image_of(const vision::Circle<double>& circle) {
  const auto& [c, n, r] = circle;
  Mat<double, 3, 3> K;
  K << 525, 0, 319.5, 0, 500, 239.5, 0, 0, 1;
  const Mat<double, 3, 3> dual =
      K * (c * c.transpose() - r * r * (Mat<double, 3, 3>::Identity() - n * n.transpose())) * K.transpose();
  const Vec<double, 2> centre = dual.block<2, 1>(0, 2) / dual(2, 2);
  const Mat<double, 2, 2> shape = centre * centre.transpose() - dual.block<2, 2>(0, 0) / dual(2, 2);
  const double m00 = std::sqrt(shape(0, 0)), m10 = shape(1, 0) / m00, m11 = std::sqrt(shape(1, 1) - m10 * m10);
  return {q16(centre.x()), q16(centre.y()), q16(m00), q16(m10), q16(m11)};
}

TEST(RingPosition, IsExactFaceToFaceOnTheOpticalAxis) {
  const auto p = vision::ring_position<double>(image_of({{0, 0, 0.7}, {0, 0, -1}, 0.025}), 0.025, camera());
  ASSERT_TRUE(p.ok());
  EXPECT_LT((p.value() - Vec<double, 3>{0, 0, 0.7}).norm(), 1e-5);  // a Q16 pixel in 18
}

TEST(RingPosition, IsWithinASmallPartOfTheRangeUnderTiltAndFarOffTheAxis) {
  for (const double tilt : {-0.9, 0.2, 0.6, 1.0}) {
    const Vec<double, 3> c{0.32, -0.18, 0.8};
    const double r = 0.025;
    const auto p = vision::ring_position<double>(image_of({c, {std::sin(tilt), 0, -std::cos(tilt)}, r}), r, camera());
    ASSERT_TRUE(p.ok());
    // Second order in r / distance, for the direction and for the range: 0.0008 of the distance each, at most.
    EXPECT_LT((p.value() - c).norm(), 2 * r * r / c.squaredNorm() * c.norm()) << tilt;
  }
}

TEST(RingPosition, RefusesAnEmptyEllipse) {
  EXPECT_EQ(vision::ring_position<double>({}, 0.025, camera()).status(), Status::bad_argument);
}

}  // namespace
}  // namespace articam
