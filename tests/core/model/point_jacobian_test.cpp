#include "core/model/point_jacobian.hpp"

#include <gtest/gtest.h>

#include "static_models/registry.hpp"
#include "tests/support/random_state.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

template <class M>
class PointJacobian : public testing::Test {};
using Models = testing::Types<test::Arm, test::GearedArm, models::PrinterDrawer, models::Mire>;
TYPED_TEST_SUITE(PointJacobian, Models);

TYPED_TEST(PointJacobian, TimesQdotIsTheVelocityOfEveryMarkerInTheCamera) {
  using M = TypeParam;
  constexpr int kDof = model::kDof<M>;
  constexpr double h = 1e-6;  // central difference: error about h^2 + 1e-16 / h
  test::Random random{3};
  for (int i = 0; i < 50; ++i) {
    const auto q = random.configuration<M, double>();
    const Vec<double, kDof> qdot = random.vector<double, kDof>(-1, 1);
    const auto k = model::forward_kinematics<M, double>(q.joints);
    const auto place = [](const auto& at, std::size_t m) -> Vec<double, 3> {
      return at.T_cam_obj * model::forward_kinematics<M, double>(at.joints).markers[m].centre;
    };
    const auto plus = model::integrate<M, double>(q, h * qdot), minus = model::integrate<M, double>(q, -h * qdot);
    for (std::size_t m = 0; m < M::kMarkers.size(); ++m) {
      const Vec<double, 6> twist = model::point_jacobian<M, double>(k, q.T_cam_obj, M::kMarkers[m].body) * qdot;
      const Vec<double, 3> X = place(q, m);
      const Vec<double, 3> velocity = twist.head<3>() + twist.tail<3>().cross(X);  // v_0 + omega x X
      EXPECT_LT((velocity - (place(plus, m) - place(minus, m)) / (2 * h)).norm(), 1e-9) << M::kMarkers[m].name;
    }
  }
}

}  // namespace
}  // namespace articam
