#include "tools/report/marks.hpp"

#include <gtest/gtest.h>

#include "core/model/point_jacobian.hpp"
#include "static_models/registry.hpp"
#include "tests/support/random_state.hpp"
#include "tests/support/test_arm.hpp"
#include "tests/tools/report/static_table.hpp"

namespace articam::report {
namespace {

/// The parsed model stands and moves as the compiled one, to the rounding of the rows.
template <class M>
void expect_same(const modelgen::Table& table) {
  articam::test::Random random{7};
  for (int trial = 0; trial < 10; ++trial) {
    const auto joints = random.vector<double, model::kNumJoints<M>>(-1, 1);
    const auto k = model::forward_kinematics<M, double>(joints);
    const Marks marks = place_marks(table, joints);
    ASSERT_EQ(marks.centre.size(), M::kMarkers.size());
    for (std::size_t m = 0; m < M::kMarkers.size(); ++m) {
      EXPECT_LT((marks.centre[m] - k.markers[m].centre).norm(), 1e-13) << M::kMarkers[m].name;
      EXPECT_LT((marks.normal[m] - k.markers[m].normal).norm(), 1e-13) << M::kMarkers[m].name;
      const auto J = model::point_jacobian<M, double>(k, Pose<double>{}, M::kMarkers[m].body);
      for (int j = 0; j < model::kNumJoints<M>; ++j) {
        const Vec3 omega = J.template block<3, 1>(3, 6 + j);
        const Vec3 velocity = J.template block<3, 1>(0, 6 + j) + omega.cross(k.markers[m].centre);
        EXPECT_LT((marks.velocity[m].col(j) - velocity).norm(), 1e-13) << M::kMarkers[m].name;
      }
    }
  }
}

TEST(Marks, OfTheParsedModelAreThoseOfTheCompiledOne) {
  for (const auto name : models::kStaticModelNames) {
    SCOPED_TRACE(name);
    const modelgen::Table table = test::static_table(std::string(name));
    EXPECT_TRUE(models::visit_model(name, [&]<class Model>() { expect_same<Model>(table); }));
  }
}

}  // namespace
}  // namespace articam::report
