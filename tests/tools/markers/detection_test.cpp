// The firmware's detector looks at printed sheets, and at markers that were cut out and glued.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/vision/detector.hpp"
#include "tests/tools/markers/printed_page.hpp"
#include "tools/markers/layout.hpp"

namespace articam::markers {
namespace {

using model::MarkerKind;
using test::PrintedPage;

constexpr double kRatio = 50.0 / 122;

const std::vector<Mark> kMarks{
    {"ring_a", MarkerKind::ring, 50, 50 * kRatio}, {"light_a", MarkerKind::dot_light_on_dark, 18.5},
    {"dark_a", MarkerKind::dot_dark_on_light, 20}, {"ring_b", MarkerKind::ring, 60, 60 * kRatio},
    {"dark_b", MarkerKind::dot_dark_on_light, 30}, {"light_b", MarkerKind::dot_light_on_dark, 40}};

vision::MarkKind seen_as(MarkerKind kind) {
  return kind == MarkerKind::ring                ? vision::MarkKind::ring
         : kind == MarkerKind::dot_light_on_dark ? vision::MarkKind::dot_light_on_dark
                                                 : vision::MarkKind::dot_dark_on_light;
}

vision::Detections detect(const PrintedPage& page, MarkerKind kind) {
  vision::DetectorOptions options;
  options.rings = kind == MarkerKind::ring;
  options.dots_light_on_dark = kind == MarkerKind::dot_light_on_dark;
  options.dots_dark_on_light = kind == MarkerKind::dot_dark_on_light;
  const auto detector = std::make_unique<vision::Detector>(options);
  vision::Detections found;
  EXPECT_EQ(detector->detect({page.grey.data(), page.width_px, page.height_px, page.width_px}, found), Status::ok);
  return found;
}

double diameter_px(const vision::Ellipse& e) {
  return 2 * std::sqrt(vision::from_q16(e.m00_q16) * vision::from_q16(e.m11_q16));  // of the circle of that area
}

/// The detection of that mark, or null.
const vision::Detection* find(const vision::Detections& found, const PrintedPage& page, const Piece& piece) {
  constexpr double kNear_px = 0.5;
  const auto there = std::find_if(found.begin(), found.end(), [&](const vision::Detection& detection) {
    const double u = vision::from_q16(detection.outer.u_q16), v = vision::from_q16(detection.outer.v_q16);
    return detection.kind == seen_as(piece.mark.kind) &&
           std::hypot(u - piece.x_mm / page.pixel_mm + 0.5, v - piece.y_mm / page.pixel_mm + 0.5) < kNear_px;
  });
  return there == found.end() ? nullptr : &*there;
}

class DetectedSheet : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::can_print(Format::pdf)) GTEST_SKIP() << "needs pdftoppm (poppler-utils)";
    sheets_ = lay_out(kMarks, kPapers[1], 10);
    ASSERT_TRUE(sheets_);
  }

  std::optional<Sheets> sheets_;
};

TEST_F(DetectedSheet, ShowsEveryMarkWithItsSizeAndNoRingThatIsNone) {
  const auto pages = test::print(*sheets_, Format::pdf, 80);  // A4 within the largest frame
  ASSERT_EQ(pages.size(), sheets_->pages.size());
  for (std::size_t i = 0; i < pages.size(); ++i) {
    std::ptrdiff_t num_rings = 0;
    for (const Piece& piece : sheets_->pages[i]) {
      const auto found = detect(pages[i], piece.mark.kind);
      const vision::Detection* const detection = find(found, pages[i], piece);
      ASSERT_NE(detection, nullptr) << piece.mark.name;
      // Poppler's smoothing darkens every edge by 0.07 px; the detector's own error at edges as sharp as these is less.
      // 0.3 px are 0.1 mm on paper.
      EXPECT_NEAR(diameter_px(detection->outer), piece.mark.outer_mm / pages[i].pixel_mm, 0.3) << piece.mark.name;
      num_rings += piece.mark.kind == MarkerKind::ring;
    }
    const auto rings = detect(pages[i], MarkerKind::ring);
    EXPECT_EQ(std::count_if(rings.begin(), rings.end(), [](const auto& ring) { return diameter_px(ring.outer) > 12; }),
              num_rings);  // letters may look like smaller ones
  }
}

/// All but the square becomes that grey: the piece is cut out and glued onto something else.
PrintedPage glued(const PrintedPage& page, const Piece& piece, std::uint8_t grey) {
  PrintedPage glued = page;
  std::ranges::fill(glued.grey, grey);
  page.visit(piece.square(), [&](double x_mm, double y_mm, double dark) {
    const auto u = static_cast<std::size_t>(x_mm / page.pixel_mm), v = static_cast<std::size_t>(y_mm / page.pixel_mm);
    glued.grey[v * static_cast<std::size_t>(page.width_px) + u] = static_cast<std::uint8_t>(255 * (1 - dark));
  });
  return glued;
}

TEST_F(DetectedSheet, IsSeenFromAfarWhereAPieceIsGluedOntoAnyGround) {
  constexpr double kSmallest_px = 12;  // what the README promises
  for (const Mark& mark : kMarks) {
    const auto sheets = lay_out(std::vector{mark}, kPapers[1], 10);
    const auto pages = test::print(*sheets, Format::pdf, 25.4 * kSmallest_px / mark.outer_mm);
    ASSERT_EQ(pages.size(), 1u);
    const Piece& piece = sheets->pages[0][0];
    for (const std::uint8_t grey : std::array<std::uint8_t, 5>{0, 60, 128, 200, 255}) {
      const PrintedPage page = glued(pages[0], piece, grey);
      EXPECT_NE(find(detect(page, mark.kind), page, piece), nullptr) << mark.name << " on grey " << int{grey};
    }
  }
}

}  // namespace
}  // namespace articam::markers
