#include "core/tracker/mark_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "static_models/arm7/arm7.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "static_models/stress24/stress24.hpp"
#include "static_models/switch_panel/switch_panel.hpp"

namespace articam {
namespace {

using OfPrinter = tracker::MarkOrder<models::PrinterDrawer>;
static_assert(OfPrinter::kIsChain && OfPrinter::kNumSlots == 1, "one joint slides on the other");
static_assert(OfPrinter::kNumGroups == 3, "two drawers' marks and the four of the base");
static_assert(OfPrinter::kGroups[0].turns && !OfPrinter::kGroups[1].turns && !OfPrinter::kGroups[2].turns,
              "nothing turns; that one drawer's frame stands on its head makes no difference");

template <class M>
class MarkOrder : public testing::Test {};
using Models = testing::Types<models::PrinterDrawer, models::SwitchPanel, models::Arm7, models::Stress24>;
TYPED_TEST_SUITE(MarkOrder, Models);

TYPED_TEST(MarkOrder, HasEveryMarkerOnceAndABodyAfterThoseBehindIt) {
  using Order = tracker::MarkOrder<TypeParam>;
  auto sorted = Order::kSorted;
  EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end(), [](std::size_t a, std::size_t b) {
    return TypeParam::kMarkers[a].body > TypeParam::kMarkers[b].body;
  }));
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t m = 0; m < sorted.size(); ++m) EXPECT_EQ(sorted[m], m);
}

TYPED_TEST(MarkOrder, CoversTheMarkersByGroupsOfOneBodyAndOneFacing) {
  using Order = tracker::MarkOrder<TypeParam>;
  std::size_t next = 0;
  for (const auto& group : Order::kGroups) {
    EXPECT_EQ(group.begin, next);
    for (std::size_t i = 0; i < group.size; ++i, ++next) {
      EXPECT_EQ(TypeParam::kMarkers[Order::kSorted[next]].body, group.body);
      EXPECT_TRUE(Order::kFacing[Order::kSorted[next]] == group.facing);
    }
  }
  EXPECT_EQ(next, TypeParam::kMarkers.size());
}

}  // namespace
}  // namespace articam
