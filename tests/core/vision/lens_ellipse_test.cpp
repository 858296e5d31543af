#include "core/vision/lens_ellipse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Dense>

#include "core/vision/imaged_ellipse.hpp"
#include "tests/core/vision/circle_scene.hpp"
#include "tests/support/wide_lenses.hpp"

namespace articam {
namespace {

using vision::PlaneEllipse;

/// The circle of 72 px whose image's centre is this pixel, tilted so about x and y.
vision::Circle<double> large_circle(const vision::CameraModel<double>& camera, const Vec<double, 2>& pixel,
                                    double tilt_x, double tilt_y) {
  const Vec<double, 3> ray = camera.unproject(pixel).value().homogeneous();
  const double radius_m = 36 / std::sqrt(camera.project_with_slope(ray.head<2>()).value().J.determinant());
  const Quat<double> turn = math::exp_so3<double>({tilt_x, tilt_y, 0});
  return {ray, -(turn * ray.normalized()), radius_m};
}

std::vector<Vec<double, 2>> image_of_edge(const PlaneEllipse<double>& e, const vision::CameraModel<double>& camera,
                                          int points) {
  std::vector<Vec<double, 2>> edge;
  for (int i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * i / points;
    edge.push_back(camera.project(e.centre + e.M * Vec<double, 2>{std::cos(t), std::sin(t)}));
  }
  return edge;
}

/// The ellipse of a detector that moves it by the harmonics of 720 rays' offsets until they vanish. Each ray meets the
/// edge where it crosses a side of the closed polygon.
PlaneEllipse<double> seen_by_a_detector(const std::vector<Vec<double, 2>>& edge, PlaneEllipse<double> e) {
  constexpr int kRays = 720;
  for (int iteration = 0; iteration < 30; ++iteration) {
    std::vector<Vec<double, 2>> w;
    for (const auto& p : edge) w.push_back(e.M.inverse() * (p - e.centre));
    Vec<double, 5> sums = Vec<double, 5>::Zero();
    std::size_t side = 0;
    const auto crosses = [&](const Vec<double, 2>& ray) {
      const Vec<double, 2>&a = w[side], &b = w[(side + 1) % w.size()];
      return ray.x() * a.y() <= ray.y() * a.x() && ray.x() * b.y() > ray.y() * b.x() && ray.dot(a) > 0;
    };
    for (int k = 0; k < kRays; ++k) {
      const double t = 2 * std::numbers::pi * k / kRays;
      const Vec<double, 2> ray{std::cos(t), std::sin(t)};
      for (std::size_t i = 0; i < w.size() && !crosses(ray); ++i) side = (side + 1) % w.size();
      const Vec<double, 2>&a = w[side], &b = w[(side + 1) % w.size()];
      const double offset = (a.x() * b.y() - a.y() * b.x()) / (ray.x() * (b - a).y() - ray.y() * (b - a).x()) - 1;
      sums += offset * Vec<double, 5>{1, 2 * ray.x(), 2 * ray.y(), 2 * std::cos(2 * t), 2 * std::sin(2 * t)} / kRays;
    }
    Mat<double, 2, 2> stretch;
    stretch << sums[0] + sums[3], sums[4], sums[4], sums[0] - sums[3];
    e.centre += e.M * sums.segment<2>(1);
    e.M = vision::lower_triangular<double>(e.M + e.M * stretch);
  }
  return e;
}

/// The conic through points by algebraic least squares, as cv::fitEllipse has it.
Vec<double, 2> centre_of_conic(const std::vector<Vec<double, 2>>& edge, const PlaneEllipse<double>& near) {
  Eigen::MatrixXd D(static_cast<long>(edge.size()), 5);
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const Vec<double, 2> s = (edge[i] - near.centre) / near.M(0, 0);
    D.row(static_cast<long>(i)) << s.x() * s.x(), s.x() * s.y(), s.y() * s.y(), s.x(), s.y();
  }
  const Eigen::VectorXd k = D.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(D.rows()));
  Eigen::Matrix2d Q;
  Q << 2 * k[0], k[1], k[1], 2 * k[2];
  return near.centre + near.M(0, 0) * Q.inverse() * Eigen::Vector2d{-k[3], -k[4]};
}

/// Calls check(circle's ellipse, camera) all over the image of every lens, at tilts up to 60 degrees.
template <class Check>
void everywhere(const Check& check) {
  for (const auto& p : test::wide_lenses()) {
    const vision::CameraModel<double> camera{p};
    for (const auto& pixel : {Vec<double, 2>{322, 236}, {480, 120}, {590, 430}, {50, 50}, {600, 240}}) {
      for (const auto& [tilt_x, tilt_y] : {std::pair{0.0, 0.0}, {0.6, -0.3}, {-0.7, 0.7}, {0.1, 1.0}}) {
        check(vision::imaged_ellipse(large_circle(camera, pixel, tilt_x, tilt_y)).value(), camera);
      }
    }
  }
}

TEST(LensEllipse, IsTheOneThatADetectorSeesOfALargeMarkAnywhereInAWideImage) {
  double farthest_px = 0;
  everywhere([&](const PlaneEllipse<double>& on_plane, const vision::CameraModel<double>& camera) {
    const auto e = vision::distorted_ellipse(on_plane, camera);
    ASSERT_TRUE(e.ok());
    const auto seen = seen_by_a_detector(image_of_edge(on_plane, camera, 7200), e.value());
    // A polygon of 7200 sides cuts 4e-7 of 45 px off.
    EXPECT_LT((e.value().centre - seen.centre).norm(), 1e-5);
    EXPECT_LT((e.value().M - seen.M).norm(), 1e-5);
    farthest_px = std::max(farthest_px, (camera.project(on_plane.centre) - seen.centre).norm());
  });
  EXPECT_GT(farthest_px, 4.0) << "the image of the ellipse's centre would do as well";
}

TEST(LensEllipse, HasTheCentreThatOtherFitsFindWithin2Millipixels) {
  everywhere([](const PlaneEllipse<double>& on_plane, const vision::CameraModel<double>& camera) {
    const auto e = vision::distorted_ellipse(on_plane, camera);
    ASSERT_TRUE(e.ok());
    // What is left of the curve, its third harmonic, is shared out differently.
    EXPECT_LT((e.value().centre - centre_of_conic(image_of_edge(on_plane, camera, 720), e.value())).norm(), 2e-3);
  });
}

TEST(LensEllipse, IsTheAffineImageInAPinhole) {
  const vision::CameraModel<double> camera{test::camera_with(DistortionModel::plumb_bob, {})};
  PlaneEllipse<double> on_plane{{0.3, -0.2}, Mat<double, 2, 2>::Zero()};
  on_plane.M << 0.05, 0, -0.01, 0.03;
  const auto e = vision::distorted_ellipse(on_plane, camera);
  ASSERT_TRUE(e.ok());
  EXPECT_LT((e.value().centre - Vec<double, 2>{322 + 410 * 0.3, 236 - 405 * 0.2}).norm(), 1e-12);
  EXPECT_LT((e.value().M - (Mat<double, 2, 2>{} << 20.5, 0, -4.05, 12.15).finished()).norm(), 1e-12);
  const auto back = vision::undistorted_ellipse(e.value(), camera);
  ASSERT_TRUE(back.ok());
  EXPECT_LT((back.value().M - on_plane.M).norm(), 1e-15);
}

TEST(LensEllipse, IsRefusedBeyondTheLensAndWhereEmpty) {
  const vision::CameraModel<double> camera{test::camera_with(DistortionModel::plumb_bob, {-0.5, 0.1})};  // folds at 1
  const Mat<double, 2, 2> size = 0.1 * Mat<double, 2, 2>::Identity();
  EXPECT_TRUE(vision::distorted_ellipse<double>({{0.7, 0}, size}, camera).ok());
  EXPECT_EQ(vision::distorted_ellipse<double>({{0.95, 0}, size}, camera).status(), Status::outside_domain);
  EXPECT_EQ(vision::distorted_ellipse<double>({{1.5, 0}, size}, camera).status(), Status::outside_domain);
  EXPECT_EQ(vision::undistorted_ellipse<double>({{2000, 236}, 30 * size}, camera).status(), Status::outside_domain);
  EXPECT_EQ(vision::undistorted_ellipse(vision::Ellipse{}, camera).status(), Status::bad_argument);
  const double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(vision::undistorted_ellipse<double>({{kNaN, 0}, size}, camera).status(), Status::bad_argument);
  EXPECT_EQ(vision::undistorted_ellipse<double>({{330, 240}, kNaN * size}, camera).status(), Status::bad_argument);
}

TEST(PlaneEllipse, IsTheSameInFixedPointButForItsRounding) {
  PlaneEllipse<double> e{{123.4567891, -2.25}, Mat<double, 2, 2>::Zero()};
  e.M << 18.000001, 0, -3.3, 12.7;
  const auto back = vision::from_q16<double>(vision::to_q16(e));
  EXPECT_LT((back.centre - e.centre).cwiseAbs().maxCoeff(), 0.50001 / 65536);
  EXPECT_LT((back.M - e.M).cwiseAbs().maxCoeff(), 0.50001 / 65536);
  e.centre.x() = std::numeric_limits<double>::quiet_NaN();
  e.centre.y() = 1e300;
  EXPECT_EQ(vision::to_q16(e).u_q16, -32767 * 65536);
  EXPECT_EQ(vision::to_q16(e).v_q16, 32767 * 65536);
}

TEST(PlaneEllipse, HasTheSemiMajorAxisOfItsLargestSingularValue) {
  PlaneEllipse<double> e;
  e.M << 18, 0, -3.3, 12.7;
  EXPECT_NEAR(vision::semi_major(e), (Eigen::JacobiSVD<Eigen::Matrix2d>{e.M}.singularValues()[0]), 1e-14);
}

TEST(LensEllipse, IsUndoneByItsInverse) {
  everywhere([](const PlaneEllipse<double>& on_plane, const vision::CameraModel<double>& camera) {
    const auto e = vision::distorted_ellipse(on_plane, camera);
    ASSERT_TRUE(e.ok());
    const auto back = vision::undistorted_ellipse(e.value(), camera);
    ASSERT_TRUE(back.ok());
    EXPECT_LT((back.value().centre - on_plane.centre).norm(), 1e-11);
    EXPECT_LT((back.value().M - on_plane.M).norm(), 1e-11);
    const vision::CameraModel<float> in_float{camera.parameters()};
    const auto back_in_float =
        vision::undistorted_ellipse<float>({e.value().centre.cast<float>(), e.value().M.cast<float>()}, in_float);
    ASSERT_TRUE(back_in_float.ok());
    EXPECT_LT((back_in_float.value().centre.cast<double>() - on_plane.centre).norm(), 2e-6);
    EXPECT_LT((back_in_float.value().M.cast<double>() - on_plane.M).norm(), 2e-6);
  });
}

}  // namespace
}  // namespace articam
