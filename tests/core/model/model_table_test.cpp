#include "core/model/model_table.hpp"

#include <gtest/gtest.h>

#include "static_models/registry.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

using test::Arm;

static_assert(model::Model<Arm>);
static_assert(model::Model<models::PrinterDrawer> && model::Model<models::Mire> && model::Model<models::MireDistance>);
static_assert(model::kDof<Arm> == 10 && model::kDof<models::Mire> == 6);

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
