#include "tools/report/symmetry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "static_models/registry.hpp"
#include "tests/tools/report/static_table.hpp"
#include "tests/tools/report/urdf_text.hpp"

namespace articam::report {
namespace {

using Exchange = std::vector<std::size_t>;

std::vector<Exchange> exchanges(const modelgen::Table& table) {
  std::vector<Exchange> all;
  for (const Symmetry& s : find_symmetries(table)) all.push_back(s.takes_place_of);
  return all;
}

const std::string kSquare = test::dot("a", "base", "-0.1 -0.1 0") + test::dot("b", "base", "0.1 -0.1 0") +
                            test::dot("c", "base", "0.1 0.1 0") + test::dot("d", "base", "-0.1 0.1 0");

TEST(FindSymmetries, FindsTheThreeTurnsOfASquare) {
  const auto table = test::compile(kSquare, test::dots({"a", "b", "c", "d"})).table;
  const auto found = exchanges(table);
  EXPECT_EQ(found.size(), 3u);
  for (const Exchange& turn : {Exchange{1, 2, 3, 0}, Exchange{2, 3, 0, 1}, Exchange{3, 0, 1, 2}}) {
    EXPECT_NE(std::find(found.begin(), found.end(), turn), found.end());
  }
}

TEST(FindSymmetries, FindsNoneWhereOneMarkDiffersInSizeOrInFacing) {
  const std::string other = "  - {frame: d, type: dot, diameter_m: 0.02, polarity: dark_on_light}\n";
  EXPECT_TRUE(exchanges(test::compile(kSquare, test::dots({"a", "b", "c"}) + other).table).empty());
  const std::string turned = test::dot("a", "base", "-0.1 -0.1 0") + test::dot("b", "base", "0.1 -0.1 0") +
                             test::dot("c", "base", "0.1 0.1 0", "2 0 0") + test::dot("d", "base", "-0.1 0.1 0");
  EXPECT_TRUE(exchanges(test::compile(turned, test::dots({"a", "b", "c", "d"})).table).empty());
}

TEST(FindSymmetries, FindsThoseAcrossAMotionOfTheJoints) {
  // Half a turn about z lays the left drawer where the right one was: with their openings exchanged, nothing tells.
  const auto table =
      test::compile(test::dot("a", "base", "0 -0.1 0") + test::dot("b", "base", "0 0.1 0") +
                        test::slide("left", "base", "left_drawer", "0 0 -1") +
                        test::slide("right", "base", "right_drawer", "0 0 -1") +
                        test::dot("l", "left_drawer", "-0.2 0 0") + test::dot("r", "right_drawer", "0.2 0 0"),
                    test::dots({"a", "b", "l", "r"}))
          .table;
  const auto found = find_symmetries(table);
  const auto half_turn = std::find_if(found.begin(), found.end(), [](const Symmetry& s) {
    return s.takes_place_of == Exchange{1, 0, 3, 2};
  });
  ASSERT_NE(half_turn, found.end());
  EXPECT_NEAR(half_turn->turn_rad.norm(), std::numbers::pi, 1e-5);
  EXPECT_NEAR(half_turn->other_joints[0], half_turn->joints[1], 1e-6);
  EXPECT_NEAR(half_turn->other_joints[1], half_turn->joints[0], 1e-6);
}

TEST(FindSymmetries, KnowsThatAWholeTurnLooksTheSameEvenWithIdentities) {
  const std::string rim = kSquare + "<link name='wheel'/>" + test::dot("rim", "wheel", "0 0.2 0") +
                          test::dot("e", "base", "0.02 -0.1 0.03");
  const auto wheel = [&](const char* lower, const char* upper) {
    const std::string limit = std::string("<axis xyz='0 0 1'/><limit lower='") + lower + "' upper='" + upper + "'/>";
    return find_symmetries(test::compile(rim + test::joint("turn", "revolute", "base", "wheel", limit),
                                         test::dots({"a", "b", "c", "d", "e", "rim"}))
                               .table);
  };
  EXPECT_TRUE(wheel("-1", "1").empty());
  const auto found = wheel("-9", "9");
  ASSERT_FALSE(found.empty());
  for (const Symmetry& s : found) {
    EXPECT_FALSE(s.needs_identities());
    EXPECT_NEAR(std::remainder(s.joints[0] - s.other_joints[0], 2 * std::numbers::pi), 0, 1e-6);
  }
}

TEST(FindSymmetries, TakesNoJointThatNothingTellsOfForOne) {
  const auto table = test::compile(kSquare + test::dot("e", "base", "0.02 -0.1 0.03") + "<link name='wheel'/>" +
                                       test::joint("turn", "continuous", "base", "wheel", "<axis xyz='0 0 1'/>") +
                                       test::dot("hub", "wheel", "0 0 0"),
                                   test::dots({"a", "b", "c", "d", "e", "hub"}))
                         .table;
  EXPECT_TRUE(find_symmetries(table).empty());
}

/// What is reported is so: the second configuration has its marks where the first has them.
TEST(FindSymmetries, ReportsOnlyWhatIsTrue) {
  for (const auto name : models::kStaticModelNames) {
    SCOPED_TRACE(name);
    const modelgen::Table table = test::static_table(std::string(name));
    for (const Symmetry& s : find_symmetries(table)) {
      const Marks first = place_marks(table, s.joints), second = place_marks(table, s.other_joints);
      for (std::size_t m = 0; m < table.markers.size(); ++m) {  // a rigid motion keeps distances
        for (std::size_t k = 0; k < m; ++k) {
          const double before = (first.centre[m] - first.centre[k]).norm();
          const double after = (second.centre[s.takes_place_of[m]] - second.centre[s.takes_place_of[k]]).norm();
          EXPECT_NEAR(before, after, 2 * s.residual_m + 1e-9);
        }
      }
    }
  }
  EXPECT_TRUE(find_symmetries(test::static_table("printer_drawer")).empty());
}

}  // namespace
}  // namespace articam::report
