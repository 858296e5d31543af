#include "core/vision/interaction_matrix.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/math/so3.hpp"
#include "tests/support/random_state.hpp"

namespace articam {
namespace {

Vec<double, 2> project(const Vec<double, 3>& p) { return p.head<2>() / p.z(); }

TEST(InteractionMatrix, EqualsTheNumericDerivativeOfTheProjection) {
  test::Random random{4};
  constexpr double h = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const Vec<double, 3> p{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(0.3, 2)};
    const auto L = vision::interaction_matrix<double>(project(p), p.z());
    ASSERT_TRUE(L.ok());
    for (int c = 0; c < 6; ++c) {
      const Vec<double, 6> v = Vec<double, 6>::Unit(c);
      // The camera moves by v: a point at rest moves by -v - w x p in its frame.
      const Vec<double, 3> velocity = -v.head<3>() - v.tail<3>().cross(p);
      const Vec<double, 2> sdot = (project(p + h * velocity) - project(p - h * velocity)) / (2 * h);
      EXPECT_LT((L.value().col(c) - sdot).norm(), 1e-8) << c;  // h^2 times a third derivative of up to 1e3
    }
  }
}

TEST(InteractionMatrix, RefusesAPointBehindTheCameraAndADepthThatIsNotANumber) {
  EXPECT_EQ(vision::interaction_matrix<double>({0, 0}, -1.0).status(), Status::behind_camera);
  EXPECT_EQ(vision::interaction_matrix<double>({0, 0}, std::numeric_limits<double>::quiet_NaN()).status(),
            Status::behind_camera);
}

}  // namespace
}  // namespace articam
