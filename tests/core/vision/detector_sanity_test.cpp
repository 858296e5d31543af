#include "core/vision/detector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

namespace articam::vision {
namespace {

// Checkers, blocks of noise, and rings within rings about a random centre, each light, dark or random.
std::uint8_t grey_of(int pattern, int u, int v, int block_px, std::mt19937& random) {
  switch (pattern) {
    case 0:
      return ((u / block_px + v / block_px) & 1) != 0 ? 230 : 20;
    case 1:
      return static_cast<std::uint8_t>(random());
    case 2:
      return static_cast<std::uint8_t>((u / block_px * 73856093) ^ (v / block_px * 19349663));
    case 3:
      return static_cast<int>(std::hypot(u - 70.3, 0.7 * v - 50.6)) / block_px % 2 != 0 ? 230 : 20;
    default:
      return static_cast<std::uint8_t>(
          static_cast<unsigned>(std::hypot(u - 60.1, v - 61.7)) / static_cast<unsigned>(block_px) * 37 + random() % 30);
  }
}

void expect_sane(const Ellipse& e, const ImageView& image) {
  EXPECT_GE(e.u_q16, 0);
  EXPECT_GE(e.v_q16, 0);
  EXPECT_LT(e.u_q16 >> kQ16, image.width_px);
  EXPECT_LT(e.v_q16 >> kQ16, image.height_px);
  EXPECT_GT(e.m00_q16, 0);
  EXPECT_GT(e.m11_q16, 0);
  EXPECT_LT(2 * (e.m00_q16 >> kQ16), image.width_px);
  EXPECT_LT(2 * std::hypot(from_q16(e.m10_q16), from_q16(e.m11_q16)), image.height_px);
}

TEST(Detector, ReportsSaneEllipsesOnlyOnCheckersNoiseAndNestedRings) {
  constexpr unsigned kSeed = 11;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  const auto everything = std::make_unique<Detector>(
      DetectorOptions{.rings = true, .dots_light_on_dark = true, .dots_dark_on_light = true});
  std::vector<std::uint8_t> pixels(std::size_t{kMaxImageWidth_px} * kMaxImageHeight_px);
  Detections out;
  for (int run = 0; run < 400; ++run) {
    const int width = run == 0 ? kMaxImageWidth_px : 1 + static_cast<int>(random() % 200);
    const int height = run == 0 ? kMaxImageHeight_px : 1 + static_cast<int>(random() % 200);
    const int pattern = run % 5, block_px = 1 + run / 5 % 12;
    for (int i = 0; i < width * height; ++i) {
      pixels[static_cast<std::size_t>(i)] = grey_of(pattern, i % width, i / width, block_px, random);
    }
    const ImageView image{pixels.data(), width, height, width};
    ASSERT_EQ(everything->detect(image, out), Status::ok);
    for (const Detection& mark : out) {
      expect_sane(mark.outer, image);
      if (mark.kind == MarkKind::ring) expect_sane(mark.inner, image);
      EXPECT_GT(mark.centre_variance_q24, 0u);
    }
  }
}

}  // namespace
}  // namespace articam::vision
