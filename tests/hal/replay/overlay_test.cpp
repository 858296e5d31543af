#include "hal/replay/overlay.hpp"

#include <gtest/gtest.h>

#include <cairo.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/own_folder.hpp"

namespace articam::hal {
namespace {

namespace fs = std::filesystem;

constexpr int kQ16One = 1 << 16;

struct Rgb {
  int r, g, b;
};

/// Read back by cairo, which has also written it: about what is drawn, not about PNG.
class Picture {
 public:
  explicit Picture(const fs::path& file)
      : surface_{cairo_image_surface_create_from_png(file.c_str()), &cairo_surface_destroy} {}

  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  Rgb at(int x, int y) const {
    const unsigned char* data = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    const std::uint32_t pixel = reinterpret_cast<const std::uint32_t*>(data + y * stride)[x];
    return {static_cast<int>(pixel >> 16 & 255), static_cast<int>(pixel >> 8 & 255), static_cast<int>(pixel & 255)};
  }

 private:
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
};

class OverlayPicture : public testing::Test {
 protected:
  OverlayPicture() { fs::create_directories(folder_); }
  ~OverlayPicture() override { fs::remove_all(folder_); }

  Picture draw(const Overlay& overlay) const {
    const std::vector<std::uint8_t> pixels(100 * 80, 40);
    std::string why;
    EXPECT_EQ(write_overlay(folder_ / "a.png", {pixels.data(), 100, 80, 100}, overlay, why), Status::ok) << why;
    return Picture{folder_ / "a.png"};
  }

  const fs::path folder_ = test::own_folder();
};

// Four times the frame's size: the pixel (u, v) has its centre at 4 u + 2.
constexpr int in_picture(double px) { return static_cast<int>(4 * px + 2); }

constexpr vision::Ellipse circle(int u_px, int v_px, int radius_px) {
  return {u_px * kQ16One, v_px * kQ16One, radius_px * kQ16One, 0, radius_px * kQ16One};
}

TEST_F(OverlayPicture, OutlinesBothEdgesOfARingWhereTheyAre) {
  const Picture picture =
      draw({.seen = {{{.kind = vision::MarkKind::ring, .outer = circle(50, 40, 20), .inner = circle(50, 40, 8)}, ""}}});
  ASSERT_EQ(picture.width(), 400);
  for (const double radius_px : {8.0, 20.0}) {
    const Rgb edge = picture.at(in_picture(50), in_picture(40 - radius_px));
    EXPECT_GT(edge.r, 150) << radius_px;  // yellow, a line of 1.2 px
    EXPECT_LT(edge.b, 60) << radius_px;
  }
  const Rgb between = picture.at(in_picture(50), in_picture(40 - 14));
  EXPECT_EQ(between.r, 40);
  EXPECT_EQ(between.b, 40);
}

TEST_F(OverlayPicture, ShowsAMatchedFeatureGreenAndAnUnmatchedOneRed) {
  for (const bool matched : {true, false}) {
    const Picture picture = draw({.predicted = {{"lid", circle(30, 40, 15), matched, matched ? "" : "gate"}}});
    int green = 0, red = 0;
    for (int y = 0; y < 320; ++y) {
      for (int x = 0; x < 400; ++x) {
        const Rgb pixel = picture.at(x, y);
        green += pixel.g > 180 && pixel.r < 120 ? 1 : 0;
        red += pixel.r > 180 && pixel.g < 120 ? 1 : 0;
      }
    }
    EXPECT_GT(matched ? green : red, 100);
    EXPECT_EQ(matched ? red : green, 0);
  }
}

TEST_F(OverlayPicture, NamesFlawsInWords) {
  EXPECT_EQ(names_of_flaws(0), "");
  EXPECT_EQ(names_of_flaws(vision::kSaturated), "saturated");
  EXPECT_EQ(names_of_flaws(vision::kBlurred | vision::kClipped | vision::kOccluded), "blurred clipped occluded");
}

TEST_F(OverlayPicture, LeavesNothingBehindWhereItCannotBeWritten) {
  std::string why;
  const std::vector<std::uint8_t> pixels(16, 0);
  EXPECT_EQ(write_overlay(folder_ / "none" / "a.png", {pixels.data(), 4, 4, 4}, {}, why), Status::io_error);
  EXPECT_NE(why.find("a.png"), std::string::npos);
  EXPECT_EQ(write_overlay(folder_ / "a.png", {}, {}, why), Status::bad_argument);
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace articam::hal
