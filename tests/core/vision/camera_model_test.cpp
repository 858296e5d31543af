#include "core/vision/camera_model.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include <opencv2/calib3d.hpp>

#include "tests/support/random_state.hpp"

namespace articam {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kModels{DistortionModel::plumb_bob, DistortionModel::rational_polynomial,
                             DistortionModel::equidistant};

CameraParameters wide_lens() {
  CameraParameters p;
  p.width_px = 640, p.height_px = 480;
  p.fx_px = 410, p.fy_px = 405, p.cx_px = 322, p.cy_px = 236;
  p.distortion = {-0.31, 0.11, 0.0012, -0.0007, -0.018};
  return p;
}

/// A VGA camera with a lens of this kind, from barrel to pincushion.
CameraParameters random_camera(test::Random& random, DistortionModel model) {
  CameraParameters p;
  p.width_px = 640, p.height_px = 480;
  p.fx_px = random.uniform(250, 700), p.fy_px = p.fx_px * random.uniform(0.95, 1.05);
  p.cx_px = random.uniform(300, 340), p.cy_px = random.uniform(220, 260);
  p.distortion_model = model;
  if (model == DistortionModel::equidistant) {
    for (std::size_t i = 0; i < 4; ++i) p.distortion[i] = random.uniform(-0.05, 0.05);
    return p;
  }
  p.distortion = {random.uniform(-0.35, 0.2), random.uniform(-0.1, 0.15), random.uniform(-0.003, 0.003),
                  random.uniform(-0.003, 0.003), random.uniform(-0.03, 0.03)};
  if (model == DistortionModel::rational_polynomial) {
    for (std::size_t i = 5; i < 8; ++i) p.distortion[i] = random.uniform(-0.1, 0.3);
  }
  return p;
}

/// Points on the metric plane inside the lens's domain, a fisheye's to 80 degrees, the others' as far as VGA shows.
std::vector<Vec<double, 2>> points_in_domain(test::Random& random, const CameraParameters& p) {
  const vision::CameraModel<double> camera{p};
  const double most = p.distortion_model == DistortionModel::equidistant ? 5.6 : 1.1;
  std::vector<Vec<double, 2>> points;
  for (int i = 0; i < 100; ++i) {
    const double radius = most * random.uniform(0, 1), angle = random.uniform(-3.15, 3.15);
    const Vec<double, 2> s{radius * std::cos(angle), radius * std::sin(angle)};
    if (camera.in_domain(1.02 * s)) points.push_back(s);  // not on the fold itself, where no inverse has digits
  }
  return points;
}

struct OpenCvCamera {
  explicit OpenCvCamera(const CameraParameters& p)
      : K{p.fx_px, 0, p.cx_px, 0, p.fy_px, p.cy_px, 0, 0, 1},
        D(p.distortion.begin(), p.distortion.begin() + static_cast<long>(num_coefficients(p.distortion_model))),
        fisheye{p.distortion_model == DistortionModel::equidistant} {}

  Vec<double, 2> project(const Vec<double, 2>& s) const {
    const std::vector<cv::Point3d> points{{s.x(), s.y(), 1}};
    std::vector<cv::Point2d> pixels;
    if (fisheye) {
      cv::fisheye::projectPoints(points, pixels, cv::Vec3d{}, cv::Vec3d{}, K, D);
    } else {
      cv::projectPoints(points, cv::Vec3d{}, cv::Vec3d{}, K, D, pixels);
    }
    return {pixels[0].x, pixels[0].y};
  }
  Vec<double, 2> unproject(const Vec<double, 2>& pixel) const {
    const std::vector<cv::Point2d> pixels{{pixel.x(), pixel.y()}};
    std::vector<cv::Point2d> s;
    const cv::TermCriteria until{cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 2000, 1e-15};
    if (fisheye) {
      cv::fisheye::undistortPoints(pixels, s, K, D, cv::noArray(), cv::noArray(), until);
    } else {
      cv::undistortPoints(pixels, s, K, D, cv::noArray(), cv::noArray(), until);
    }
    return {s[0].x, s[0].y};
  }

  cv::Matx33d K;
  std::vector<double> D;
  bool fisheye;
};

TEST(CameraModel, ProjectsAsOpenCvDoes) {
  test::Random random{7};
  for (const auto model : kModels) {
    for (int c = 0; c < 40; ++c) {
      const auto p = random_camera(random, model);
      const vision::CameraModel<double> camera{p};
      const vision::CameraModel<float> in_float{p};
      const OpenCvCamera open_cv{p};
      const auto points = points_in_domain(random, p);
      ASSERT_GT(points.size(), 30u);
      for (const auto& s : points) {
        const Vec<double, 2> pixel = open_cv.project(s);
        EXPECT_LT((camera.project(s) - pixel).norm(), 1e-9) << static_cast<int>(model);
        EXPECT_LT((in_float.project(s.cast<float>()).cast<double>() - pixel).norm(), 1e-3) << static_cast<int>(model);
      }
    }
  }
}

TEST(CameraModel, UnprojectsToWhatOpenCvProjectsBackThere) {
  test::Random random{8};
  for (const auto model : kModels) {
    for (int c = 0; c < 40; ++c) {
      const auto p = random_camera(random, model);
      const vision::CameraModel<double> camera{p};
      const vision::CameraModel<float> in_float{p};
      const OpenCvCamera open_cv{p};
      for (const auto& truth : points_in_domain(random, p)) {
        const Vec<double, 2> pixel = open_cv.project(truth);
        const auto s = camera.unproject(pixel);
        ASSERT_TRUE(s.ok()) << static_cast<int>(model) << ' ' << truth.transpose();
        EXPECT_LT((open_cv.project(s.value()) - pixel).norm(), 1e-9) << static_cast<int>(model);
        const auto sf = in_float.unproject(pixel.cast<float>());
        ASSERT_TRUE(sf.ok()) << static_cast<int>(model) << ' ' << truth.transpose();
        EXPECT_LT((open_cv.project(sf.value().cast<double>()) - pixel).norm(), 1e-3) << static_cast<int>(model);
      }
    }
  }
}

TEST(CameraModel, UnprojectsAsOpenCvDoesWhereThatConverges) {
  test::Random random{9};
  int compared = 0;
  for (const auto model : kModels) {
    for (int c = 0; c < 20; ++c) {
      const auto p = random_camera(random, model);
      const vision::CameraModel<double> camera{p};
      const OpenCvCamera open_cv{p};
      for (const auto& truth : points_in_domain(random, p)) {
        const Vec<double, 2> pixel = camera.project(truth), theirs = open_cv.unproject(pixel);
        if (!((open_cv.project(theirs) - pixel).norm() < 1e-10)) continue;  // its plain iteration may not settle
        const auto s = camera.unproject(pixel);
        ASSERT_TRUE(s.ok());
        if ((theirs - truth).norm() > 1e-6) continue;  // beyond the fold, where it takes the other root
        EXPECT_LT((s.value() - theirs).norm(), 1e-9 / p.fx_px * 100) << static_cast<int>(model);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 3000);
}

TEST(CameraModel, JacobianEqualsTheNumericDerivativeOfTheProjection) {
  test::Random random{10};
  constexpr double h = 1e-6;
  for (const auto model : kModels) {
    const auto p = random_camera(random, model);
    const vision::CameraModel<double> camera{p};
    auto points = points_in_domain(random, p);
    points.insert(points.end(), {{0, 0}, {1e-9, 0}, {0, 1e-5}});
    for (const auto& s : points) {
      const Mat<double, 2, 2> J = camera.project_with_slope(s).value().J;
      for (int i = 0; i < 2; ++i) {
        const Vec<double, 2> step = h * Vec<double, 2>::Unit(i);
        const Vec<double, 2> slope = (camera.project(s + step) - camera.project(s - step)) / (2 * h);
        // Rounding of 1e-13 px over 2 h, and the third derivative
        EXPECT_LT((J.col(i) - slope).norm(), 1e-6) << static_cast<int>(model) << ' ' << s.transpose();
      }
    }
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
      EXPECT_LT((camera.project(s.value()) - pixel).norm(), 1e-9);
      const auto sf = in_float.unproject(pixel.cast<float>());
      ASSERT_TRUE(sf.ok());
      EXPECT_LT((camera.project(sf.value().cast<double>()) - pixel).norm(), 1e-3);
    }
  }
}

TEST(CameraModel, HoldsUpToTheFirstFoldAlthoughThePolynomialRisesAgain) {
  auto p = wide_lens();
  p.distortion = {-0.5, 0.1};  // r (1 - 0.5 r^2 + 0.1 r^4): slope 1 - 1.5 r^2 + 0.5 r^4, negative from 1 to sqrt(2)
  const vision::CameraModel<double> camera{p};
  EXPECT_TRUE(camera.in_domain({0.999, 0}));
  EXPECT_FALSE(camera.in_domain({1.001, 0}));
  EXPECT_FALSE(camera.in_domain({1.6, 0}));
  EXPECT_EQ(camera.unproject(camera.project({1.6, 0})).status(), Status::outside_domain);
  const auto s = camera.unproject(camera.project({0, -0.99}));
  ASSERT_TRUE(s.ok());
  EXPECT_LT((s.value() - Vec<double, 2>{0, -0.99}).norm(), 1e-9);
}

TEST(CameraModel, RefusesPixelsBeyondTheFoldOfTheLensAndNumbersThatAreNot) {
  test::Random random{11};
  const vision::CameraModel<double> camera{wide_lens()};
  EXPECT_EQ(camera.unproject({4000, 3000}).status(), Status::outside_domain);
  EXPECT_EQ(camera.unproject({kNaN, 0}).status(), Status::bad_argument);
  auto p = wide_lens();
  p.distortion_model = DistortionModel::equidistant;
  p.distortion = {};
  const vision::CameraModel<double> fisheye{p};
  EXPECT_TRUE(fisheye.unproject({322 + 410 * 1.48, 236}).ok());                            // 84.8 degrees
  EXPECT_EQ(fisheye.unproject({322 + 410 * 1.49, 236}).status(), Status::outside_domain);  // 85.4 degrees
  p.distortion[0] = kNaN;
  EXPECT_EQ(vision::CameraModel<double>{p}.unproject({330, 240}).status(), Status::outside_domain);
}

}  // namespace
}  // namespace articam
