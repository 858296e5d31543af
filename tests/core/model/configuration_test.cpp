#include "core/model/configuration.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/random_state.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

using test::Arm;

TEST(Configuration, DifferenceIsTheInverseOfIntegrate) {
  test::Random random{1};
  for (int i = 0; i < 200; ++i) {
    const auto q = random.configuration<Arm, double>();
    const Vec<double, 10> step = random.vector<double, 10>(-1, 1);
    const Vec<double, 10> back = model::difference(q, model::integrate<Arm, double>(q, step));
    EXPECT_LT((back - step).cwiseAbs().maxCoeff(), 1e-14) << i;  // a few roundings of numbers near 1
  }
}

TEST(Configuration, StaysAUnitQuaternionOverAMillionSteps) {
  auto q = test::Random{2}.configuration<Arm, float>();
  const Vec<float, 10> step = Vec<float, 10>::Constant(0.01f);
  for (int i = 0; i < 1'000'000; ++i) q = model::integrate<Arm, float>(q, step);
  EXPECT_NEAR(q.T_cam_obj.R.norm(), 1.0f, 2e-7f);  // one rounding of a float
}

TEST(Configuration, TurnsAboutTheCamerasAxesNotTheObjects) {
  model::Configuration<Arm, double> q;
  q.T_cam_obj.R = math::exp_so3<double>({0, 0, 1.5});
  Vec<double, 10> step = Vec<double, 10>::Zero();
  step[3] = 0.25;  // about x of {cam}
  const auto moved = model::integrate<Arm, double>(q, step);
  const Quat<double> expected = math::exp_so3<double>({0.25, 0, 0}) * q.T_cam_obj.R;
  EXPECT_LT(moved.T_cam_obj.R.angularDistance(expected), 1e-15);
}

TEST(Configuration, TakesNumbersInTheOrderOfTheFilesAndNormalisesTheQuaternion) {
  const auto q = model::from_numbers<Arm, double>({1, 2, 3, 0, 0, 4, 0, 5, 6, 7, 8});
  ASSERT_TRUE(q.ok());
  EXPECT_EQ(q.value().T_cam_obj.t, (Vec<double, 3>{1, 2, 3}));
  EXPECT_EQ(q.value().T_cam_obj.R.coeffs(), (Quat<double>{0, 0, 1, 0}.coeffs()));
  EXPECT_EQ(q.value().joints, (Vec<double, 4>{5, 6, 7, 8}));
}

TEST(Configuration, RefusesNumbersThatAreNotFiniteAndAZeroQuaternion) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  EXPECT_EQ((model::from_numbers<Arm, double>({kNaN, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0})).status(), Status::bad_argument);
  EXPECT_EQ((model::from_numbers<Arm, double>({0, 0, 0, 1, 0, 0, 0, 0, 0, 0, kInf})).status(), Status::bad_argument);
  EXPECT_EQ((model::from_numbers<Arm, double>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})).status(), Status::bad_argument);
}

}  // namespace
}  // namespace articam
