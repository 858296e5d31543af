#include "core/vision/hole_offset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/vision/plane_ellipse.hpp"
#include "tests/core/vision/circle_scene.hpp"
#include "tests/core/vision/marker_scene.hpp"

namespace articam {
namespace {

using vision::HoleOffset;

constexpr std::int32_t kRatio_q16 = 26859;

struct Ring {
  vision::Ellipse seen;
  Vec<double, 2> offset_px;  ///< of its hole, from the dual conics of both circles
  double size;               ///< radius by distance
};

Ring seen_by(const vision::Circle<double>& circle) {
  const auto in_pixels = [](vision::PlaneEllipse<double> e) {
    e.centre = test::kVga.fx_px * e.centre + Vec<double, 2>{test::kVga.cx_px, test::kVga.cy_px};
    e.M *= test::kVga.fx_px;
    return e;
  };
  const auto ring = in_pixels(test::image_of(circle));
  const auto hole = in_pixels(test::image_of({circle.centre, circle.normal, circle.radius * kRatio_q16 / 65536}));
  return {vision::to_q16(ring), hole.centre - ring.centre, circle.radius / circle.centre.z()};
}

TEST(HoleOffset, OneOfBothIsTheDualConics) {
  const auto camera = vision::pinhole_of(test::kVga);
  test::Random random{71};
  for (int i = 0; i < 3000; ++i) {
    const Ring ring = seen_by(test::circle_in_view(random));
    HoleOffset offset;
    ASSERT_TRUE(vision::hole_offset(ring.seen, camera, kRatio_q16, offset)) << i;
    const auto px = [](std::int32_t u_q16, std::int32_t v_q16) {
      return Vec<double, 2>{vision::from_q16(u_q16), vision::from_q16(v_q16)};
    };
    const Vec<double, 2> mean = px(offset.mean_u_q16, offset.mean_v_q16),
                         half = px(offset.half_u_q16, offset.half_v_q16);
    const double error = std::min((mean + half - ring.offset_px).norm(), (mean - half - ring.offset_px).norm());
    // First order in the square of the size. The square of the tilt has the ellipse's rounding, to 2e-4 of it: its root
    // is known to a hundredth at worst.
    const double scale = vision::from_q16(offset.scale_q16);
    EXPECT_LT(error, scale * (4 * ring.size * ring.size + (half.norm() < 0.05 * scale ? 0.02 : 0.002)) + 1e-4) << i;
  }
}

TEST(HoleOffset, OfARingThatIsTurnedToTheCameraInTheMiddleIsNone) {
  const auto camera = vision::pinhole_of(test::kVga);
  HoleOffset offset;
  ASSERT_TRUE(vision::hole_offset(seen_by({{0, 0, 0.5}, {0, 0, -1}, 0.025}).seen, camera, kRatio_q16, offset));
  for (const std::int32_t q16 : {offset.mean_u_q16, offset.mean_v_q16, offset.half_u_q16, offset.half_v_q16})
    EXPECT_LT(std::abs(q16), 100);  // a rounding of 1e-5 of an axis is a tilt of a quarter degree
  EXPECT_NEAR(vision::from_q16(offset.major_q16), 525 * 0.05, 1e-3);
}

TEST(HoleOffset, RefusesWhatIsFarOffTheAxis) {
  const vision::Pinhole camera = vision::pinhole_of(test::kVga);
  HoleOffset offset;
  EXPECT_FALSE(vision::hole_offset({2300 << 16, 0, 9 << 16, 0, 9 << 16}, camera, kRatio_q16, offset));
}

TEST(Pinhole, OfNumbersThatAreNoCamerasIsNotKnown) {
  CameraParameters camera = test::kVga;
  for (const double fx_px : {0.0, 15.0 * 15 / 525, -525.0, std::nan("")}) {
    camera.fx_px = fx_px;
    EXPECT_FALSE(vision::pinhole_of(camera).known()) << fx_px;
  }
  EXPECT_TRUE(vision::pinhole_of(test::kVga).ok());
  EXPECT_FALSE((vision::Pinhole{.focal_q16 = -1}.ok()));
  EXPECT_FALSE((vision::Pinhole{.focal_q16 = 525 << 16, .unsure_q16 = -1}.ok()));
}

TEST(Pinhole, OfAnUnknownCameraIsNearThatOfMost) {
  const vision::Pinhole likely = vision::likely_pinhole(640, 480), known = vision::pinhole_of(test::kVga);
  EXPECT_NEAR(vision::from_q16(likely.focal_q16), 525, 30);
  EXPECT_EQ(likely.u_q16, known.u_q16);
  EXPECT_EQ(likely.v_q16, known.v_q16);
  CameraParameters fisheye = test::kVga;
  fisheye.distortion[0] = 0.1;
  EXPECT_GT(vision::pinhole_of(fisheye).unsure_q16, known.unsure_q16);
}

}  // namespace
}  // namespace articam
