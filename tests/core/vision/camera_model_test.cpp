#include "core/vision/camera_model.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include <opencv2/calib3d.hpp>

#include "tests/support/random_state.hpp"

namespace articam {
namespace {

CameraParameters wide_lens() {
  CameraParameters p;
  p.width_px = 640, p.height_px = 480;
  p.fx_px = 410, p.fy_px = 405, p.cx_px = 322, p.cy_px = 236;
  p.distortion = {-0.31, 0.11, 0.0012, -0.0007, -0.018};
  return p;
}

TEST(CameraModel, ProjectsAsOpenCvDoes) {
  const auto p = wide_lens();
  const vision::CameraModel<double> camera{p};
  test::Random random{7};
  std::vector<cv::Point3d> points;
  for (int i = 0; i < 200; ++i) points.emplace_back(random.uniform(-0.7, 0.7), random.uniform(-0.5, 0.5), 1.0);
  const cv::Matx33d K{p.fx_px, 0, p.cx_px, 0, p.fy_px, p.cy_px, 0, 0, 1};
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(points, cv::Vec3d{}, cv::Vec3d{}, K, std::vector<double>(p.distortion.begin(), p.distortion.end()),
                    pixels);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec<double, 2> ours = camera.project({points[i].x, points[i].y});
    EXPECT_LT((ours - Vec<double, 2>{pixels[i].x, pixels[i].y}).norm(), 1e-9) << i;
  }
}

TEST(CameraModel, UnprojectIsTheInverseOfProjectAllOverTheImage) {
  const vision::CameraModel<double> camera{wide_lens()};
  const vision::CameraModel<float> in_float{wide_lens()};
  for (int v = 0; v < 480; v += 37) {
    for (int u = 0; u < 640; u += 41) {
      const Vec<double, 2> pixel{u, v};
      const auto s = camera.unproject(pixel);
      ASSERT_TRUE(s.ok()) << u << ' ' << v;
      EXPECT_LT((camera.project(s.value()) - pixel).norm(), 1e-8);
      const auto sf = in_float.unproject(pixel.cast<float>());
      ASSERT_TRUE(sf.ok());
      EXPECT_LT((camera.project(sf.value().cast<double>()) - pixel).norm(),
                2e-3);  // 1e-6 on the metric plane and rounding
    }
  }
}

TEST(CameraModel, RefusesPixelsBeyondTheFoldOfTheLensAndNumbersThatAreNot) {
  const vision::CameraModel<double> camera{wide_lens()};
  EXPECT_EQ(camera.unproject({4000, 3000}).status(), Status::outside_domain);
  EXPECT_EQ(camera.unproject({std::numeric_limits<double>::quiet_NaN(), 0}).status(), Status::bad_argument);
}

}  // namespace
}  // namespace articam
