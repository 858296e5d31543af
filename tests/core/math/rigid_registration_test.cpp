#include "core/math/rigid_registration.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/random_state.hpp"

namespace articam {
namespace {

using Points = std::vector<Vec<double, 3>>;

Result<Pose<double>> registered(const Points& a, const Points& b) {
  return math::rigid_registration<double>(std::span<const Vec<double, 3>>(a), std::span<const Vec<double, 3>>(b));
}

const Points kRectangle{{-0.16, -0.1, 0}, {0.16, -0.1, 0}, {0.16, 0.02, 0}, {-0.16, 0.02, 0}};

TEST(RigidRegistration, RecoversThePoseThatMovedThePoints) {
  test::Random random{24};
  for (int i = 0; i < 100; ++i) {
    const Pose<double> T{math::exp_so3<double>(random.vector<double, 3>(-3, 3)), random.vector<double, 3>(-1, 1)};
    Points moved;
    for (const auto& p : kRectangle) moved.push_back(T * p);
    const auto found = registered(moved, kRectangle);
    ASSERT_TRUE(found.ok());
    EXPECT_LT((found.value().t - T.t).norm(), 1e-14);
    EXPECT_LT(found.value().R.angularDistance(T.R), 1e-7);  // acos loses half the digits near 1
  }
}

TEST(RigidRegistration, NeverReflectsWhateverTheNoiseDoesToCoplanarPoints) {
  test::Random random{25};
  for (int i = 0; i < 500; ++i) {
    Points noisy;
    for (const auto& p : kRectangle) noisy.push_back(p + random.vector<double, 3>(-0.3, 0.3));
    const auto found = registered(noisy, kRectangle);
    if (!found.ok()) continue;
    EXPECT_NEAR(found.value().R.toRotationMatrix().determinant(), 1, 1e-12);
  }
}

TEST(RigidRegistration, IsTheMinimumOfTheSumOfSquares) {
  test::Random random{26};
  Points noisy;
  for (const auto& p : kRectangle) noisy.push_back(p + random.vector<double, 3>(-0.01, 0.01));
  const auto cost = [&](const Pose<double>& T) {
    double sum = 0;
    for (std::size_t i = 0; i < noisy.size(); ++i) sum += (T * kRectangle[i] - noisy[i]).squaredNorm();
    return sum;
  };
  const auto best = registered(noisy, kRectangle).value();
  for (int i = 0; i < 200; ++i) {
    const Pose<double> other{math::exp_so3<double>(random.vector<double, 3>(-0.01, 0.01)) * best.R,
                             best.t + random.vector<double, 3>(-0.001, 0.001)};
    EXPECT_GE(cost(other), cost(best));
  }
}

TEST(RigidRegistration, RefusesTooFewUnequalAndCollinearPoints) {
  const Points two(kRectangle.begin(), kRectangle.begin() + 2);
  EXPECT_EQ(registered(two, two).status(), Status::too_few_features);
  EXPECT_EQ(registered(kRectangle, two).status(), Status::bad_argument);
  const Points line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  EXPECT_EQ(registered(line, line).status(), Status::ill_conditioned);
}

}  // namespace
}  // namespace articam
