#include "tools/markers/layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace articam::markers {
namespace {

using model::MarkerKind;

// Sums of a few hundred mm in double are exact to 1e-13.
constexpr double kRounding_mm = 1e-9;

bool inside(const Box& inner, const Box& outer) {
  return inner.x_mm >= outer.x_mm - kRounding_mm && inner.y_mm >= outer.y_mm - kRounding_mm &&
         inner.right_mm() <= outer.right_mm() + kRounding_mm && inner.bottom_mm() <= outer.bottom_mm() + kRounding_mm;
}

bool overlap(const Box& a, const Box& b) {
  return a.x_mm < b.right_mm() - kRounding_mm && b.x_mm < a.right_mm() - kRounding_mm &&
         a.y_mm < b.bottom_mm() - kRounding_mm && b.y_mm < a.bottom_mm() - kRounding_mm;
}

/// 1 to 40 marks of 3 to 100 mm, which fit on all papers.
std::vector<Mark> random_marks(std::mt19937& random) {
  constexpr std::array kKinds{MarkerKind::ring, MarkerKind::dot_light_on_dark, MarkerKind::dot_dark_on_light};
  std::vector<Mark> marks(1 + random() % 40);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const double outer_mm = 3 + static_cast<double>(random() % 9700) / 100;
    marks[i] = {"mark_" + std::to_string(i), kKinds[random() % kKinds.size()], outer_mm, outer_mm / 3};
  }
  return marks;
}

/// Calls law(marks, sheets) for many lists of marks on all papers.
template <class Law>
void for_many_sheets(Law&& law) {
  constexpr unsigned kSeed = 41;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random{kSeed};
  for (int i = 0; i < 100; ++i) {
    const auto marks = random_marks(random);
    const double margin_mm = static_cast<double>(random() % 15);
    for (const Paper& paper : kPapers) {
      const auto sheets = lay_out(marks, paper, margin_mm);
      ASSERT_TRUE(sheets);
      law(marks, *sheets);
    }
  }
}

TEST(Layout, PlacesEveryMarkExactlyOnce) {
  for_many_sheets([](const std::vector<Mark>& marks, const Sheets& sheets) {
    std::map<std::string, int> times;
    std::size_t placed = 0;
    for (const Page& page : sheets.pages) {
      EXPECT_FALSE(page.empty());
      for (const Piece& piece : page) ++times[piece.mark.name], ++placed;
    }
    EXPECT_EQ(placed, marks.size());
    EXPECT_EQ(times.size(), marks.size());
  });
}

TEST(Layout, LetsNothingOverlapOrLeaveItsPartOfThePage) {
  for_many_sheets([](const std::vector<Mark>&, const Sheets& sheets) {
    for (const Page& page : sheets.pages) {
      for (auto piece = page.begin(); piece != page.end(); ++piece) {
        EXPECT_TRUE(inside(piece->box(), sheets.content()));
        EXPECT_TRUE(inside(piece->square(), piece->box()) && inside(piece->label(), piece->box()));
        EXPECT_FALSE(overlap(piece->square(), piece->label()));
        for (auto other = page.begin(); other != piece; ++other) EXPECT_FALSE(overlap(piece->box(), other->box()));
      }
    }
  });
}

TEST(Layout, DividesThePageIntoHeaderContentAndFooterWithinTheMargins) {
  for (const Paper& paper : kPapers) {
    for (const double margin_mm : {0.0, 10.0, kMaxMargin_mm}) {
      const Sheets sheets{paper, margin_mm, {}};
      const Box header = sheets.header(), content = sheets.content(), footer = sheets.footer();
      for (const Box& part : {header, content, footer}) EXPECT_TRUE(inside(part, sheets.printable()));
      EXPECT_NEAR(header.bottom_mm(), content.y_mm, kRounding_mm);
      EXPECT_NEAR(content.bottom_mm(), footer.y_mm, kRounding_mm);
      EXPECT_GE(footer.width_mm, kRuler_mm);
    }
  }
}

TEST(Layout, KeepsTheOrderOfEqualMarksAndPutsLargerOnesFirst) {
  const auto sheets = lay_out(std::vector<Mark>{{"a", MarkerKind::dot_dark_on_light, 20},
                                                {"b", MarkerKind::dot_dark_on_light, 20},
                                                {"c", MarkerKind::dot_dark_on_light, 30}},
                              kPapers[1], 10);
  ASSERT_TRUE(sheets);
  ASSERT_EQ(sheets->pages.size(), 1u);
  std::string names;
  for (const Piece& piece : sheets->pages[0]) names += piece.mark.name;
  EXPECT_EQ(names, "cab");
}

TEST(Layout, FillsALowerPlaceThatAWideMarkLeft) {
  // Two shelves of one large mark each leave room at their right for all the small ones.
  const Mark large{"large", MarkerKind::dot_dark_on_light, 65}, small{"small", MarkerKind::dot_dark_on_light, 20};
  const auto sheets = lay_out(std::vector{large, small, large, small}, kPapers[1], 10);
  ASSERT_TRUE(sheets);
  EXPECT_EQ(sheets->pages.size(), 1u);
}

TEST(Layout, TurnsThePaperOnlyWhereThatSavesPages) {
  const auto landscape = [](std::size_t count, double diameter_mm) {
    const auto sheets =
        lay_out(std::vector<Mark>(count, {"m", MarkerKind::dot_dark_on_light, diameter_mm}), kPapers[1], 10);
    return sheets && sheets->paper.landscape();
  };
  EXPECT_FALSE(landscape(1, 50));  // as good upright
  EXPECT_FALSE(landscape(4, 50));  // two by two upright, three in a row turned
  EXPECT_TRUE(landscape(2, 80));   // one a page upright, two in a row turned
}

TEST(Layout, LeavesEnoughPlainGroundForTheDetector) {
  // The detector's windows reach 0.41 radii out of the thickest ring that is allowed, and 0.32 out of a dot.
  for (const double diameter_mm : {1.0, 18.5, 50.0, 120.0}) {
    const Mark mark{"m", MarkerKind::ring, diameter_mm, 0.1875 * diameter_mm};
    EXPECT_GE(quiet_zone_mm(mark), 0.41 * diameter_mm / 2);
    EXPECT_GE(square_mm(mark), diameter_mm + 2 * (quiet_zone_mm(mark) + kTick_mm) - kRounding_mm);
    EXPECT_EQ(square_mm(mark), std::round(square_mm(mark)));
  }
}

TEST(Layout, RefusesAMarkThatFitsNeitherWayAndNamesThePaperThatWouldDo) {
  const std::vector<Mark> marks{
      {"small", MarkerKind::ring, 50, 20}, {"wide", MarkerKind::ring, 130, 60}, {"huge", MarkerKind::ring, 5000, 2000}};
  EXPECT_FALSE(lay_out(marks, kPapers[1], 10));
  const auto reasons = objections(marks, kPapers[1], 10);
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_EQ(reasons[0],
            "marker 'wide' needs 207 x 217 mm within the margins of A4: use --paper A3, or a smaller --margin");
  EXPECT_NE(reasons[1].find("'huge' needs 7512 x 7522 mm"), std::string::npos) << reasons[1];
  EXPECT_NE(reasons[1].find("too large for every paper"), std::string::npos) << reasons[1];
  EXPECT_TRUE(lay_out(std::span{marks}.first(2), kPapers[2], 10));
}

TEST(Marks, AreTheRingsAndDotsOfATableInMillimetresWithoutItsPoints) {
  const std::array<model::MarkerRow, 3> rows{{
      {"ring", MarkerKind::ring, -1, {}, {0, 0, 1}, 0.05, 0.02},
      {"point", MarkerKind::point, -1, {}, {0, 0, 1}, 0, 0},
      {"dot", MarkerKind::dot_light_on_dark, -1, {}, {0, 0, 1}, 0.0185, 0},
  }};
  const auto marks = marks_of(rows);
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(marks[0].name, "ring");
  EXPECT_DOUBLE_EQ(marks[0].outer_mm, 50);
  EXPECT_DOUBLE_EQ(marks[0].inner_mm, 20);
  EXPECT_EQ(marks[1].name, "dot");
  EXPECT_DOUBLE_EQ(marks[1].outer_mm, 18.5);
}

}  // namespace
}  // namespace articam::markers
