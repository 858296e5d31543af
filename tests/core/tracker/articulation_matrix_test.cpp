#include "core/tracker/articulation_matrix.hpp"

#include <gtest/gtest.h>

#include "static_models/registry.hpp"
#include "tests/support/observe.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

using tracker::FeatureKind;

template <class M>
class ArticulationMatrix : public testing::Test {};
using Models = testing::Types<test::Arm, models::PrinterDrawer, models::Mire, models::MireDistance>;
TYPED_TEST_SUITE(ArticulationMatrix, Models);

TYPED_TEST(ArticulationMatrix, EqualsTheNumericDerivativeOfTheError) {
  using M = TypeParam;
  constexpr int kDof = model::kDof<M>;
  constexpr double h = 1e-6;
  test::Random random{8};
  for (const auto kind : {FeatureKind::point, FeatureKind::imaged_circle}) {
    for (int i = 0; i < 30; ++i) {
      const auto q = random.configuration<M, double>();
      const auto matches = test::observe<M, double>(random.configuration<M, double>(), kind);
      tracker::System<M, double> at, plus, minus;
      ASSERT_EQ(stack(matches, q, kind, at), Status::ok);
      for (int c = 0; c < kDof; ++c) {
        const Vec<double, kDof> step = h * Vec<double, kDof>::Unit(c);
        ASSERT_EQ(stack(matches, model::integrate<M, double>(q, step), kind, plus), Status::ok);
        ASSERT_EQ(stack(matches, model::integrate<M, double>(q, -step), kind, minus), Status::ok);
        EXPECT_LT((at.A.col(c) - (plus.e - minus.e) / (2 * h)).cwiseAbs().maxCoeff(), 1e-8) << "column " << c;
      }
    }
  }
}

TYPED_TEST(ArticulationMatrix, IsTheSameInFloat) {
  using M = TypeParam;
  test::Random random{9};
  const auto q = random.configuration<M, double>();
  model::Configuration<M, float> qf;
  qf.T_cam_obj = {q.T_cam_obj.R.template cast<float>(), q.T_cam_obj.t.template cast<float>()};
  qf.joints = q.joints.template cast<float>();
  tracker::System<M, double> system;
  tracker::System<M, float> in_float;
  ASSERT_EQ(stack(test::observe<M, double>(q, FeatureKind::imaged_circle), q, FeatureKind::imaged_circle, system),
            Status::ok);
  ASSERT_EQ(stack(test::observe<M, float>(qf, FeatureKind::imaged_circle), qf, FeatureKind::imaged_circle, in_float),
            Status::ok);
  EXPECT_LT((system.A - in_float.A.template cast<double>()).cwiseAbs().maxCoeff(), 1e-5);  // entries of a few units
}

TEST(ArticulationMatrixRows, AreZeroWhereThereIsNoMatch) {
  using M = models::PrinterDrawer;
  const auto q = test::nominal_printer<M, double>();
  auto matches = test::observe<M, double>(q, FeatureKind::imaged_circle);
  matches[3].matched = false;
  tracker::System<M, double> system;
  ASSERT_EQ(stack(matches, q, FeatureKind::imaged_circle, system), Status::ok);
  EXPECT_TRUE((system.A.middleRows<2>(6).array() == 0).all());
}

TEST(ArticulationMatrixRows, AreRefusedWithTheObjectBehindTheCamera) {
  using M = models::PrinterDrawer;
  auto q = test::nominal_printer<M, double>();
  const auto matches = test::observe<M, double>(q, FeatureKind::imaged_circle);
  q.T_cam_obj.t.z() = -1;
  tracker::System<M, double> system;
  EXPECT_EQ(stack(matches, q, FeatureKind::imaged_circle, system), Status::behind_camera);
}

}  // namespace
}  // namespace articam
