#include "core/model/model_table.hpp"

#include <gtest/gtest.h>

#include "static_models/registry.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

using test::Arm, test::GearedArm;

static_assert(model::Model<Arm>);
static_assert(model::Model<models::PrinterDrawer> && model::Model<models::Mire> && model::Model<models::MireDistance>);
static_assert(model::kDof<Arm> == 10 && model::kDof<models::Mire> == 6);

// Two of the four joints follow the last: q holds the rod, then the lid.
static_assert(model::kNumBodies<GearedArm> == 4 && model::kNumJoints<GearedArm> == 2);
static_assert(model::kValueRows<GearedArm>[0].name == "rod" && model::kValueRows<GearedArm>[1].name == "lid");
static_assert(model::kValueOfRow<GearedArm> == std::array{1, 0, 1, 1});

template <int leader, int ratio>
struct RodMimics : GearedArm {
  static constexpr auto kJoints = [] {
    auto rows = GearedArm::kJoints;
    rows[1].leader = leader, rows[1].ratio = ratio;
    return rows;
  }();
  static constexpr std::array<double, 8> kQ0{0, 0, 0, 1, 0, 0, 0, 0};
};
static_assert(model::is_well_formed<RodMimics<3, 1>>());
static_assert(!model::is_well_formed<RodMimics<0, 1>>());  // the hinge has no value of its own
static_assert(!model::is_well_formed<RodMimics<1, 1>>());
static_assert(!model::is_well_formed<RodMimics<4, 1>>());
static_assert(!model::is_well_formed<RodMimics<3, 0>>());  // it would stand still

struct ParentAfterChild : Arm {
  static constexpr auto kJoints = [] {
    auto rows = Arm::kJoints;
    rows[0].parent = 1;
    return rows;
  }();
};
struct AxisNotUnit : Arm {
  static constexpr auto kJoints = [] {
    auto rows = Arm::kJoints;
    rows[1].axis = {1, 1, 0};
    return rows;
  }();
};
struct LimitsCrossed : Arm {
  static constexpr auto kJoints = [] {
    auto rows = Arm::kJoints;
    rows[3].q_min = 3;
    return rows;
  }();
};
struct BodyUnknown : Arm {
  static constexpr auto kMarkers = [] {
    auto rows = Arm::kMarkers;
    rows[2].body = 4;
    return rows;
  }();
};
struct HoleBiggerThanRing : Arm {
  static constexpr auto kMarkers = [] {
    auto rows = Arm::kMarkers;
    rows[0].inner_diameter_m = 0.06;
    return rows;
  }();
};
struct StartTooShort : Arm {
  static constexpr std::array<double, 10> kQ0{};
};
static_assert(!model::is_well_formed<ParentAfterChild>());
static_assert(!model::is_well_formed<AxisNotUnit>());
static_assert(!model::is_well_formed<LimitsCrossed>());
static_assert(!model::is_well_formed<BodyUnknown>());
static_assert(!model::is_well_formed<HoleBiggerThanRing>());
static_assert(!model::is_well_formed<StartTooShort>());

TEST(ModelTable, IsCheckedWhenThisFileCompiles) { SUCCEED(); }

}  // namespace
}  // namespace articam
