#include "core/vision/imaged_circle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>

#include "tests/support/random_state.hpp"

namespace articam {
namespace {

using vision::Circle;

Circle<double> random_circle(test::Random& random) {
  const Vec<double, 3> n = random.vector<double, 3>(-1, 1).normalized();
  return {{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(0.25, 1.5)},
          n,
          random.uniform(0.005, 0.06)};
}

/// The centre of the conic through 24 projected points of the circle, by linear least squares.
Vec<double, 2> centre_of_conic_through_points(const Circle<double>& circle) {
  const Vec<double, 3> a = circle.normal.unitOrthogonal(), b = circle.normal.cross(a);
  Eigen::MatrixXd D(24, 5);
  Eigen::VectorXd one = Eigen::VectorXd::Ones(24);
  const Vec<double, 2> near = circle.centre.head<2>() / circle.centre.z();  // conic about here: better conditioned
  const double size = circle.radius / circle.centre.z();
  for (int i = 0; i < 24; ++i) {
    const double t = 2 * std::numbers::pi * i / 24;
    const Vec<double, 3> p = circle.centre + circle.radius * (std::cos(t) * a + std::sin(t) * b);
    const Vec<double, 2> s = (p.head<2>() / p.z() - near) / size;
    D.row(i) << s.x() * s.x(), s.x() * s.y(), s.y() * s.y(), s.x(), s.y();
  }
  const Eigen::VectorXd k = D.colPivHouseholderQr().solve(one);
  Eigen::Matrix2d Q;
  Q << 2 * k[0], k[1], k[1], 2 * k[2];
  return near + size * Q.inverse() * Eigen::Vector2d{-k[3], -k[4]};
}

TEST(ImagedCircle, HasItsCentreAtTheCentreOfTheConicThroughItsProjectedPoints) {
  test::Random random{5};
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const auto circle = random_circle(random);
    if (std::abs(circle.normal.dot(circle.centre.normalized())) < 0.1)
      continue;  // edge on: the oracle's fit degenerates
    const auto s = vision::imaged_centre(circle);
    ASSERT_TRUE(s.ok());
    EXPECT_LT((s.value() - centre_of_conic_through_points(circle)).norm(), 1e-11) << i;
    ++compared;
  }
  EXPECT_GT(compared, 200);
}

TEST(ImagedCircle, IsOffTheProjectedCentreByTheKnownFormulaOnTheOpticalAxis) {
  // ANCHORS: at the image centre the bias is (r/z)^2 sin(tilt) cos(tilt), to second order in r/z.
  const double r = 0.025, z = 0.7, tilt = 0.7;
  const auto s = vision::imaged_centre<double>({{0, 0, z}, {std::sin(tilt), 0, -std::cos(tilt)}, r});
  ASSERT_TRUE(s.ok());
  const double bias = r * r / (z * z) * std::sin(tilt) * std::cos(tilt);
  EXPECT_NEAR(std::abs(s.value().x()), bias, bias * r * r / (z * z));
}

TEST(ImagedCircle, InteractionMatrixEqualsTheNumericDerivative) {
  test::Random random{6};
  constexpr double h = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const auto circle = random_circle(random);
    const auto L = vision::imaged_centre_interaction_matrix(circle);
    ASSERT_TRUE(L.ok());
    const auto seen_after = [&](const Vec<double, 6>& v, double t) {
      const Quat<double> turn = math::exp_so3<double>(-t * v.tail<3>());
      return vision::imaged_centre<double>(
                 {turn * circle.centre - t * v.head<3>(), turn * circle.normal, circle.radius})
          .value();
    };
    for (int c = 0; c < 6; ++c) {
      const Vec<double, 6> v = Vec<double, 6>::Unit(c);
      const Vec<double, 2> sdot = (seen_after(v, h) - seen_after(v, -h)) / (2 * h);
      EXPECT_LT((L.value().col(c) - sdot).norm(), 1e-8) << c;
    }
  }
}

TEST(ImagedCircle, OfRadiusZeroIsAPoint) {
  const Vec<double, 3> c{0.12, -0.07, 0.85};
  const auto L = vision::imaged_centre_interaction_matrix<double>({c, {0, 0, -1}, 0});
  const auto point = vision::interaction_matrix<double>(c.head<2>() / c.z(), c.z());
  ASSERT_TRUE(L.ok() && point.ok());
  EXPECT_LT((L.value() - point.value()).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(ImagedCircle, IsRefusedWhereItReachesTheCamerasPlaneOrIsNotANumber) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(vision::imaged_centre<double>({{0, 0, -1}, {0, 0, 1}, 0.1}).status(), Status::behind_camera);
  EXPECT_EQ(vision::imaged_centre<double>({{0, 0, 0.05}, {1, 0, 0}, 0.1}).status(), Status::behind_camera);
  EXPECT_EQ(vision::imaged_centre<double>({{0, 0, kNaN}, {0, 0, 1}, 0.1}).status(), Status::behind_camera);
}

}  // namespace
}  // namespace articam
