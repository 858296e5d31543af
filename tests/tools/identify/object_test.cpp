#include "tools/identify/object.hpp"

#include <gtest/gtest.h>

#include "core/model/forward_kinematics.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "static_models/stress24/stress24.hpp"
#include "static_models/valve/valve.hpp"
#include "tests/support/random_state.hpp"

namespace articam::identify {
namespace {

template <class Model>
class ObjectOf : public testing::Test {};
using Models = testing::Types<models::PrinterDrawer, models::Valve, models::Stress24>;
TYPED_TEST_SUITE(ObjectOf, Models);

TYPED_TEST(ObjectOf, PlacesMarkersAsTheCoreDoes) {
  test::Random random{1};
  const Object object = Object::of<TypeParam>();
  const auto q = random.configuration<TypeParam, double>();
  const auto kinematics = model::forward_kinematics<TypeParam, double>(q.joints);
  const auto placed = object.place(q.joints, {});
  ASSERT_EQ(placed.size(), kinematics.markers.size());
  for (std::size_t m = 0; m < placed.size(); ++m) {
    EXPECT_LT((placed[m].centre - kinematics.markers[m].centre).norm(), 1e-12);
    EXPECT_LT((placed[m].normal - kinematics.markers[m].normal).norm(), 1e-12);
  }
}

TYPED_TEST(ObjectOf, KnowsHowEveryJointAndDisplacementMovesThem) {
  test::Random random{2};
  const Object object = Object::of<TypeParam>();
  const VectorXd q = random.configuration<TypeParam, double>().joints;
  const auto placed = object.place(q, {});
  constexpr double kStep = 1e-6;  // truncation and cancellation are both below 1e-9
  for (int j = 0; j < object.num_values(); ++j) {
    const VectorXd step = kStep * VectorXd::Unit(q.size(), j);
    const auto above = object.place(q + step, {}), below = object.place(q - step, {});
    for (std::size_t m = 0; m < placed.size(); ++m) {
      const Vec3 centre = (above[m].centre - below[m].centre) / (2 * kStep);
      const Vec3 normal = (above[m].normal - below[m].normal) / (2 * kStep);
      EXPECT_LT((placed[m].centre_by_value.col(j) - centre).norm(), 1e-8);
      EXPECT_LT((placed[m].normal_by_value.col(j) - normal).norm(), 1e-8);
    }
  }
  const VectorXd displaced = VectorXd::LinSpaced(3 * object.num_markers(), 0, 0.1);
  const auto moved = object.place(q, displaced);
  for (std::size_t m = 0; m < placed.size(); ++m) {
    const Vec3 d = displaced.segment<3>(static_cast<Eigen::Index>(3 * m));
    EXPECT_LT((moved[m].centre - placed[m].centre - placed[m].R_obj_body * d).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace articam::identify
