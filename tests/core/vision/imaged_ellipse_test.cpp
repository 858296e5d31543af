#include "core/vision/imaged_ellipse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/core/vision/circle_scene.hpp"

namespace articam {
namespace {

using vision::Circle;

template <class S>
Vec<S, 5> numbers(const vision::PlaneEllipse<S>& e) {
  return (Vec<S, 5>{} << e.centre, e.M(0, 0), e.M(1, 0), e.M(1, 1)).finished();
}

Circle<float> in_float(const Circle<double>& circle) {
  return {circle.centre.cast<float>(), circle.normal.cast<float>(), static_cast<float>(circle.radius)};
}

TEST(ImagedEllipse, IsTheDualConicOfTheCircleInDoubleAndInFloat) {
  test::Random random{31};
  for (int i = 0; i < 2000; ++i) {
    const auto circle = test::circle_in_view(random);
    const auto exact = numbers(test::image_of(circle));
    const auto e = vision::imaged_ellipse(circle);
    ASSERT_TRUE(e.ok());
    EXPECT_LT((numbers(e.value()) - exact).norm(), 1e-12) << i;  // the oracle's own subtraction, 1e-16 / (r / z)
    const auto ef = vision::imaged_ellipse(in_float(circle));
    ASSERT_TRUE(ef.ok());
    EXPECT_LT((numbers(ef.value()).cast<double>() - exact).norm(), 1e-6) << i;  // 5e-4 px at f = 525
  }
}

TEST(ImagedEllipse, HasTheCentreOfTheCentresFunctionAndMovesWithIt) {
  test::Random random{32};
  for (int i = 0; i < 200; ++i) {
    const auto circle = test::circle_in_view(random);
    const auto L = vision::moving_ellipse(circle);
    ASSERT_TRUE(L.ok());
    EXPECT_LT((vision::imaged_ellipse(circle).value().centre - vision::imaged_centre(circle).value()).norm(), 1e-14);
    const Mat<double, 2, 6> of_centre = vision::imaged_centre_interaction_matrix(circle).value();
    EXPECT_LT((L.value().L.topRows<2>() - of_centre).norm(), 1e-12);
  }
}

TEST(ImagedEllipse, InteractionMatrixEqualsTheNumericDerivative) {
  test::Random random{33};
  constexpr double h = 1e-6;
  for (int i = 0; i < 500; ++i) {
    const auto circle = test::circle_in_view(random);
    const auto L = vision::moving_ellipse(circle);
    const auto Lf = vision::moving_ellipse(in_float(circle));
    ASSERT_TRUE(L.ok() && Lf.ok());
    const auto seen_after = [&](const Vec<double, 6>& v, double t) {
      const Quat<double> turn = math::exp_so3<double>(-t * v.tail<3>());
      return numbers(
          vision::imaged_ellipse<double>({turn * circle.centre - t * v.head<3>(), turn * circle.normal, circle.radius})
              .value());
    };
    for (int c = 0; c < 6; ++c) {
      const Vec<double, 6> v = Vec<double, 6>::Unit(c);
      const Vec<double, 5> sdot = (seen_after(v, h) - seen_after(v, -h)) / (2 * h);
      EXPECT_LT((L.value().L.col(c) - sdot).norm(), 1e-7) << i << ' ' << c;
      EXPECT_LT((Lf.value().L.col(c).cast<double>() - sdot).norm(), 1e-5 * (1 + sdot.norm())) << i << ' ' << c;
    }
  }
}

TEST(ImagedEllipse, DoesNotChangeWhenTheCircleTurnsAboutItsNormal) {
  const Circle<double> circle{{0.2, -0.1, 0.8}, Vec<double, 3>{0.3, 0.4, -0.9}.normalized(), 0.025};
  const auto L = vision::moving_ellipse(circle);
  ASSERT_TRUE(L.ok());
  Vec<double, 6> about_normal;  // as the camera moves, at its own origin
  about_normal << circle.centre.cross(circle.normal), circle.normal;
  EXPECT_LT((L.value().L * about_normal).norm(), 1e-15);
}

TEST(ImagedEllipse, IsRefusedEdgeOnWithoutSizeBehindTheCameraAndOnNaN) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(vision::imaged_ellipse<double>({{0, 0, 1}, {1, 0, 0}, 0.1}).status(), Status::ill_conditioned);
  EXPECT_EQ(vision::imaged_ellipse<double>({{0, 0, 1}, {0, 0, -1}, 0}).status(), Status::ill_conditioned);
  EXPECT_EQ(vision::imaged_ellipse<double>({{0, 0, 1}, {0, 0, kNaN}, 0.1}).status(), Status::ill_conditioned);
  EXPECT_EQ(vision::imaged_ellipse<double>({{0, 0, -1}, {0, 0, 1}, 0.1}).status(), Status::behind_camera);
  EXPECT_EQ(vision::moving_ellipse<double>({{0, 0, 0.05}, {0, 0, 1}, 0.1}).status(), Status::behind_camera);
}

}  // namespace
}  // namespace articam
