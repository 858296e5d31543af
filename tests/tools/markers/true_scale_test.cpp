// What is measured on a page that other programs rendered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/tools/markers/printed_page.hpp"
#include "tools/markers/layout.hpp"

namespace articam::markers {
namespace {

using model::MarkerKind;
using test::PrintedPage;

constexpr double kDpi = 400;
// Poppler's smoothing darkens an edge by a fifteenth of a pixel of 0.064 mm, twice in a diameter: 0.009 mm.
constexpr double kTolerance_mm = 0.015;
// And it moves thin upright and level lines by up to half a pixel.
constexpr double kLine_mm = 0.5 * 25.4 / kDpi + 0.005;

const std::vector<Mark> kMarks{{"ring", MarkerKind::ring, 50, 50 * 50.0 / 122},
                               {"thick", MarkerKind::ring, 30, 0.1875 * 30},
                               {"thin", MarkerKind::ring, 40, 0.75 * 40},
                               {"light", MarkerKind::dot_light_on_dark, 18.5},
                               {"dark", MarkerKind::dot_dark_on_light, 20},
                               {"tiny", MarkerKind::dot_light_on_dark, 5},
                               {"large", MarkerKind::ring, 100, 41}};

struct Measured {
  double x_mm, y_mm, outer_mm, inner_mm;
};

/// From the moments of what differs from the ground: of an annulus, with area m0 and second moment m2 about its centre,
/// m0 = pi (R^2 - r^2) and m2 / m0 = (R^2 + r^2) / 2.
Measured measure(const PrintedPage& page, const Piece& piece) {
  const bool light = piece.mark.kind == MarkerKind::dot_light_on_dark;
  const double reach_mm = piece.mark.outer_mm / 2 + 0.9 * quiet_zone_mm(piece.mark);
  const Box window{piece.x_mm - reach_mm, piece.y_mm - reach_mm, 2 * reach_mm, 2 * reach_mm};
  double m0 = 0, mx = 0, my = 0, m2 = 0;
  page.visit(window, [&](double x_mm, double y_mm, double dark) {
    const double x = x_mm - piece.x_mm, y = y_mm - piece.y_mm;
    if (x * x + y * y > reach_mm * reach_mm) return;  // the ticks are out there
    const double amount = (light ? 1 - dark : dark) * page.pixel_mm * page.pixel_mm;
    m0 += amount, mx += amount * x, my += amount * y, m2 += amount * (x * x + y * y);
  });
  const double x = mx / m0, y = my / m0;
  const double mean = m2 / m0 - x * x - y * y, half = m0 / (2 * std::numbers::pi);
  return {piece.x_mm + x, piece.y_mm + y, 2 * std::sqrt(mean + half), 2 * std::sqrt(std::max(mean - half, 0.0))};
}

/// Middles of the dark lines that cross the box upright.
std::vector<double> lines_across(const PrintedPage& page, const Box& box) {
  std::vector<double> columns, middles;
  std::vector<double> x_mm;
  page.visit(box, [&](double x, double, double dark) {
    if (x_mm.empty() || x > x_mm.back()) x_mm.push_back(x), columns.push_back(0);
    columns[static_cast<std::size_t>(std::ranges::lower_bound(x_mm, x) - x_mm.begin())] += dark;
  });
  for (std::size_t i = 0; i < columns.size(); ++i) {
    double sum = 0, moment = 0;
    for (; i < columns.size() && columns[i] > 0; ++i) sum += columns[i], moment += columns[i] * x_mm[i];
    if (sum > 0) middles.push_back(moment / sum);
  }
  return middles;
}

class PrintedSheet : public testing::TestWithParam<Format> {
 protected:
  void SetUp() override {
    if (!test::can_print(GetParam())) GTEST_SKIP() << "needs pdftoppm (poppler-utils) and rsvg-convert (librsvg2-bin)";
    sheets_ = lay_out(kMarks, kPapers[1], 10);
    ASSERT_TRUE(sheets_);
    ASSERT_GT(sheets_->pages.size(), 1u);
    pages_ = test::print(*sheets_, GetParam(), kDpi);
    ASSERT_EQ(pages_.size(), sheets_->pages.size());
    for (const PrintedPage& page : pages_) ASSERT_TRUE(page.ok());
  }

  std::optional<Sheets> sheets_;
  std::vector<PrintedPage> pages_;
};

TEST_P(PrintedSheet, HasTheSizeOfThePaper) {
  for (const PrintedPage& page : pages_) {
    EXPECT_NEAR(page.width_px * page.pixel_mm, sheets_->paper.width_mm, page.pixel_mm);
    EXPECT_NEAR(page.height_px * page.pixel_mm, sheets_->paper.height_mm, page.pixel_mm);
  }
}

TEST_P(PrintedSheet, ShowsEveryMarkInItsPlaceWithItsDiameters) {
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    for (const Piece& piece : sheets_->pages[i]) {
      const Measured measured = measure(pages_[i], piece);
      EXPECT_NEAR(measured.x_mm, piece.x_mm, kTolerance_mm) << piece.mark.name;
      EXPECT_NEAR(measured.y_mm, piece.y_mm, kTolerance_mm) << piece.mark.name;
      EXPECT_NEAR(measured.outer_mm, piece.mark.outer_mm, kTolerance_mm) << piece.mark.name;
      if (piece.mark.kind == MarkerKind::ring) {
        EXPECT_NEAR(measured.inner_mm, piece.mark.inner_mm, kTolerance_mm) << piece.mark.name;
      }
    }
  }
}

TEST_P(PrintedSheet, HasARulerOf100MillimetresOnEveryPage) {
  for (const PrintedPage& page : pages_) {
    const Box ruler = sheets_->ruler();
    constexpr double kAside_mm = 2;
    const auto strip = [&](double above_mm) {  // through the lines that are higher than that
      return lines_across(page,
                          {ruler.x_mm - kAside_mm, ruler.bottom_mm() - above_mm - 0.3, kRuler_mm + 2 * kAside_mm, 0.3});
    };
    EXPECT_EQ(strip(4).size(), 11u);
    EXPECT_EQ(strip(2.5).size(), 21u);
    const auto lines = strip(1);
    ASSERT_EQ(lines.size(), 101u);
    for (int mm = 0; mm <= 100; ++mm) {
      EXPECT_NEAR(lines[static_cast<std::size_t>(mm)] - lines[0], mm, 2 * kLine_mm);
    }
  }
}

TEST_P(PrintedSheet, HasCropMarksAtTheCornersOfTheSquareAndTicksAtItsMiddle) {
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    for (const Piece& piece : sheets_->pages[i]) {
      const Box square = piece.square(), box = piece.box();
      for (const double y_mm : {square.y_mm - 3, square.bottom_mm() + 2}) {
        const auto marks = lines_across(pages_[i], {box.x_mm, y_mm, box.width_mm, 1});
        ASSERT_EQ(marks.size(), 2u) << piece.mark.name;
        EXPECT_NEAR(marks[0], square.x_mm, kLine_mm);
        EXPECT_NEAR(marks[1], square.right_mm(), kLine_mm);
      }
      if (piece.mark.kind == MarkerKind::dot_light_on_dark) continue;  // its ticks are light
      for (const double y_mm : {square.y_mm + 0.5, square.bottom_mm() - 1.5}) {
        const auto ticks = lines_across(pages_[i], {square.x_mm, y_mm, square.width_mm, 1});
        ASSERT_EQ(ticks.size(), 1u) << piece.mark.name;
        EXPECT_NEAR(ticks[0], piece.x_mm, kLine_mm);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfBothFormats, PrintedSheet, testing::Values(Format::pdf, Format::svg),
                         [](const auto& format) { return format.param == Format::pdf ? "Pdf" : "Svg"; });

}  // namespace
}  // namespace articam::markers
