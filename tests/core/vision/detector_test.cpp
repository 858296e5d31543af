#include "core/vision/detector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "tests/core/vision/marker_scene.hpp"

namespace articam::vision {
namespace {

constexpr DetectorOptions kEverything{.rings = true, .dots_light_on_dark = true, .dots_dark_on_light = true};

std::unique_ptr<Detector> detector(const DetectorOptions& options = {}) { return std::make_unique<Detector>(options); }

Detections detect(const ImageView& image, const DetectorOptions& options = {}) {
  Detections out;
  EXPECT_EQ(detector(options)->detect(image, out), Status::ok);
  return out;
}

// Six rings of 31 px, tilted by 0.5 rad, with noise and clutter.
class DetectorLaws : public testing::Test {
 protected:
  DetectorLaws() {
    std::mt19937 random(3);
    sim::Renderer renderer(test::kVga, {});
    renderer.render(test::grid_of_markers(model::MarkerKind::ring, 3, 2, 31, 0.5, random), 0, pixels_);
  }
  ImageView image() const { return test::view_of(pixels_); }

  std::vector<std::uint8_t> pixels_;
};

void expect_same(const Detection& a, const Detection& b, std::int32_t du_px = 0, std::int32_t dv_px = 0) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.outer.u_q16 + du_px * 65536, b.outer.u_q16);
  EXPECT_EQ(a.outer.v_q16 + dv_px * 65536, b.outer.v_q16);
  EXPECT_EQ(a.outer.m00_q16, b.outer.m00_q16);
  EXPECT_EQ(a.outer.m10_q16, b.outer.m10_q16);
  EXPECT_EQ(a.outer.m11_q16, b.outer.m11_q16);
  EXPECT_EQ(a.inner.m00_q16, b.inner.m00_q16);
  EXPECT_EQ(a.centre_variance_q24, b.centre_variance_q24);
}

TEST_F(DetectorLaws, FindTheSameInTheSameFrameWhateverCameBefore) {
  const auto used = detector();
  Detections first, second;
  const std::vector<std::uint8_t> other(640 * 480, 77);
  ASSERT_EQ(used->detect(test::view_of(other), second), Status::ok);
  ASSERT_EQ(used->detect(image(), second), Status::ok);
  ASSERT_EQ(detector()->detect(image(), first), Status::ok);
  ASSERT_EQ(first.size(), 6u);
  ASSERT_EQ(second.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) expect_same(first[i], second[i]);
}

TEST_F(DetectorLaws, OrderMarksByRowThenColumn) {
  const Detections found = detect(image(), kEverything);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const Detection& a, const Detection& b) {
    return a.outer.v_q16 < b.outer.v_q16 || (a.outer.v_q16 == b.outer.v_q16 && a.outer.u_q16 < b.outer.u_q16);
  }));
}

TEST_F(DetectorLaws, DoNotDependOnTheStride) {
  std::mt19937 random(5);
  std::vector<std::uint8_t> wide(700 * 480);
  for (auto& pixel : wide) pixel = static_cast<std::uint8_t>(random());
  for (int v = 0; v < 480; ++v) std::memcpy(&wide[static_cast<std::size_t>(v * 700 + 23)], image().row(v), 640);
  const Detections plain = detect(image()), strided = detect({wide.data() + 23, 640, 480, 700});
  ASSERT_EQ(strided.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) expect_same(plain[i], strided[i]);
}

TEST_F(DetectorLaws, FollowAFrameThatMovesByWholePixels) {
  constexpr int kU = 3, kV = 5;  // not whole tiles: thresholds differ, and with them the start of the fit
  const ImageView part{image().row(kV) + kU, 640 - kU, 480 - kV, 640};
  const Detections whole = detect(image()), moved = detect(part);
  ASSERT_EQ(moved.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    // the fit forgets its start but for a hundredth of a pixel
    EXPECT_NEAR(from_q16(moved[i].outer.u_q16) + kU, from_q16(whole[i].outer.u_q16), 0.01);
    EXPECT_NEAR(from_q16(moved[i].outer.v_q16) + kV, from_q16(whole[i].outer.v_q16), 0.01);
  }
}

TEST_F(DetectorLaws, MirrorWithTheFrame) {
  std::vector<std::uint8_t> mirrored(pixels_.size());
  for (int v = 0; v < 480; ++v)
    std::reverse_copy(image().row(v), image().row(v) + 640, &mirrored[static_cast<std::size_t>(v * 640)]);
  const Detections plain = detect(image()), reversed = detect(test::view_of(mirrored));
  ASSERT_EQ(reversed.size(), plain.size());
  for (const Detection& mark : plain) {
    const bool there = std::any_of(reversed.begin(), reversed.end(), [&](const Detection& other) {
      return std::abs(from_q16(other.outer.u_q16) - (639 - from_q16(mark.outer.u_q16))) < 0.01 &&
             std::abs(from_q16(other.outer.v_q16) - from_q16(mark.outer.v_q16)) < 0.01 &&
             std::abs(from_q16(other.outer.m10_q16) + from_q16(mark.outer.m10_q16)) < 0.02;
    });
    EXPECT_TRUE(there) << from_q16(mark.outer.u_q16) << ", " << from_q16(mark.outer.v_q16);
  }
}

PixelBox box_around(const Detection& mark, int margin_px) {
  const int u = mark.outer.u_q16 >> 16, v = mark.outer.v_q16 >> 16;
  const int r = (std::max(mark.outer.m00_q16, mark.outer.m11_q16) >> 16) + margin_px;
  return {u - r, v - r, u + r, v + r};
}

TEST_F(DetectorLaws, FindInWindowsWhatTheWholeFrameShowsThereAndEachMarkOnce) {
  const Detections whole = detect(image());
  std::vector<PixelBox> windows;
  for (const Detection& mark : whole) windows.insert(windows.end(), {box_around(mark, 12), box_around(mark, 16)});
  Detections found;
  ASSERT_EQ(detector()->detect(image(), windows, found), Status::ok);
  ASSERT_EQ(found.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_NEAR(from_q16(found[i].outer.u_q16), from_q16(whole[i].outer.u_q16), 0.01);
    EXPECT_NEAR(from_q16(found[i].outer.v_q16), from_q16(whole[i].outer.v_q16), 0.01);
  }
}

TEST_F(DetectorLaws, LeaveOutMarksThatReachOverTheEdgeOfTheirWindow) {
  const Detections whole = detect(image());
  std::vector<PixelBox> windows;
  for (const Detection& mark : whole) {
    windows.push_back(box_around(mark, 12));
    windows.back().u_max_px = mark.outer.u_q16 >> 16;
  }
  windows.push_back({-100, -100, -1, -1});
  windows.push_back({640, 0, 700, 479});
  windows.push_back({10, 10, 5, 20});
  Detections found;
  ASSERT_EQ(detector()->detect(image(), windows, found), Status::ok);
  EXPECT_TRUE(found.empty());
}

TEST_F(DetectorLaws, FindEveryMarkInItsWindowThoughTheWindowBeforeIsFullOfStripes) {
  const Detections whole = detect(image());
  std::vector<std::uint8_t> taller = pixels_;
  for (int i = 0; i < 100 * 640; ++i) taller.push_back(i / 640 > 4 && i % 640 % 6 < 3 ? 20 : 230);
  std::vector<PixelBox> windows{{0, 480, 639, 579}};
  for (const Detection& mark : whole) windows.push_back(box_around(mark, 12));
  const auto crowded = detector();
  Detections found;
  ASSERT_EQ(crowded->detect({taller.data(), 640, 580, 640}, windows, found), Status::ok);
  EXPECT_TRUE(crowded->overloaded());
  ASSERT_EQ(found.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_NEAR(from_q16(found[i].outer.u_q16), from_q16(whole[i].outer.u_q16), 0.01);
    EXPECT_NEAR(from_q16(found[i].outer.v_q16), from_q16(whole[i].outer.v_q16), 0.01);
  }
}

TEST_F(DetectorLaws, DoNotReportARingAsADotToo) {
  const Detections found = detect(image(), kEverything);
  const Detections rings = detect(image());
  for (const Detection& ring : rings) {
    const auto here = std::count_if(found.begin(), found.end(), [&](const Detection& mark) {
      return std::abs(mark.outer.u_q16 - ring.outer.u_q16) < 4 * 65536 &&
             std::abs(mark.outer.v_q16 - ring.outer.v_q16) < 4 * 65536;
    });
    EXPECT_EQ(here, 1);
  }
}

// The fuzzer read 78 bytes before the frame.
TEST_F(DetectorLaws, LeaveOutExpectationsThatNoFrameCanHold) {
  const std::int32_t most = std::numeric_limits<std::int32_t>::max(), least = std::numeric_limits<std::int32_t>::min();
  const std::int32_t u = 320 << 16, v = 240 << 16, m = 20 << 16;
  const std::vector<Expected> expected{
      {MarkKind::ring, {most, v, m, 0, m}},    {MarkKind::ring, {u, least, m, 0, m}},
      {MarkKind::ring, {u, v, most, 0, most}}, {MarkKind::ring, {u, v, -m, 0, -m}},
      {MarkKind::ring, {u, v, m, most, m}},    {MarkKind::dot_light_on_dark, {u, v, m, least, m}},
      {MarkKind::dot_dark_on_light, {}}};
  Detections found;
  ASSERT_EQ(detector()->measure(image(), expected, found), Status::ok);
  EXPECT_TRUE(found.empty());
}

// What measurements cost was summed up until it overflowed, after some minutes of tracking.
TEST_F(DetectorLaws, MeasureOneFrameAfterTheOtherForHours) {
  const Detections seen = detect(image());
  ASSERT_EQ(seen.size(), 6u);
  const std::vector<Expected> expected(20000, {seen[0].kind, seen[0].outer});
  const auto used = detector();
  Detections found;
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(used->measure(image(), expected, found), Status::ok);
    ASSERT_EQ(found.size(), 1u);
  }
}

// A ratio of 0 was divided by, one of 2^31 multiplied with.
TEST_F(DetectorLaws, DoNotUseTheRatioOfRingsThatAreNotSought) {
  const Detections rings = detect(image());
  ASSERT_FALSE(rings.empty());
  for (const std::int32_t ratio_q16 : {0, std::numeric_limits<std::int32_t>::min()}) {
    const auto dots = detector({.rings = false, .dots_dark_on_light = true, .ring_ratio_q16 = ratio_q16});
    const Expected ring{MarkKind::ring, rings[0].outer};
    Detections found;
    ASSERT_EQ(dots->detect(image(), found), Status::ok);
    ASSERT_EQ(dots->measure(image(), {&ring, 1}, found), Status::ok);
    EXPECT_TRUE(found.empty());
  }
}

// A row of two changes was taken for a chord that began five kilobytes before it: the address sanitizer sees it here.
TEST(Detector, TakesNoChordThatBeginsBeforeItsRow) {
  std::vector<std::uint8_t> pixels(kMaxImageWidth_px * 16, 20);
  for (std::size_t i = 0; i < pixels.size(); i += kMaxImageWidth_px)
    pixels[i] = pixels[i + kMaxImageWidth_px - 1] = 220;
  const ImageView wide{pixels.data(), kMaxImageWidth_px, 16, kMaxImageWidth_px};
  EXPECT_TRUE(detect(wide, {.ring_ratio_q16 = kMaxRingRatio_q16}).empty());
}

TEST(Detector, RefusesAViewThatMayNotBeReadAndLeavesTheOutputAsItWas) {
  const std::vector<std::uint8_t> pixels(100, 0);
  Detections out;
  ASSERT_TRUE(out.push_back({.kind = MarkKind::dot_dark_on_light}));
  for (const ImageView& image : {ImageView{}, ImageView{pixels.data(), 10, 0, 10}, ImageView{pixels.data(), 10, 10, 9},
                                 ImageView{pixels.data(), kMaxImageWidth_px + 1, 1, kMaxImageWidth_px + 1}}) {
    EXPECT_EQ(detector()->detect(image, out), Status::bad_argument);
    EXPECT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].kind, MarkKind::dot_dark_on_light);
  }
}

TEST(Detector, FindsNothingInAnEvenFrame) {
  for (const int grey : {0, 100, 255}) {
    const std::vector<std::uint8_t> pixels(640 * 480, static_cast<std::uint8_t>(grey));
    EXPECT_TRUE(detect(test::view_of(pixels), kEverything).empty());
  }
}

TEST(Detector, FindsNothingInAnEvenFrameWithNoise) {
  sim::Renderer renderer(test::kVga, {.clutter = false});
  std::vector<std::uint8_t> pixels;
  for (std::uint64_t i_frame = 0; i_frame < 5; ++i_frame) {
    renderer.render({}, i_frame, pixels);
    EXPECT_TRUE(detect(test::view_of(pixels), kEverything).empty());
  }
}

TEST(Detector, FindsRingsOfTheRatioItIsGivenAndOfNoOther) {
  sim::Renderer renderer(test::kVga, {.clutter = false});
  std::vector<std::uint8_t> pixels;
  for (const std::int32_t ratio_q16 : {kMinRingRatio_q16, 16384, 26859, 36045, kMaxRingRatio_q16}) {
    std::mt19937 random(9);
    auto markers = test::grid_of_markers(model::MarkerKind::ring, 3, 2, 45, 0.5, random);
    for (sim::SceneMarker& marker : markers) marker.inner_radius_m = test::kRadius_m * from_q16(ratio_q16);
    renderer.render(markers, 0, pixels);
    EXPECT_EQ(detect(test::view_of(pixels), {.ring_ratio_q16 = ratio_q16}).size(), markers.size()) << ratio_q16;
    const std::int32_t other_q16 = ratio_q16 < 30000 ? ratio_q16 * 3 / 2 : ratio_q16 * 2 / 3;
    EXPECT_TRUE(detect(test::view_of(pixels), {.ring_ratio_q16 = other_q16}).empty()) << ratio_q16;
  }
}

TEST(Detector, RefusesARatioOfRingsOutOfItsRangeUnlessItSeeksNone) {
  const std::vector<std::uint8_t> pixels(640 * 480, 100);
  for (const std::int32_t ratio_q16 : {0, kMinRingRatio_q16 - 1, kMaxRingRatio_q16 + 1}) {
    Detections out;
    EXPECT_EQ(detector({.ring_ratio_q16 = ratio_q16})->detect(test::view_of(pixels), out), Status::bad_argument);
    EXPECT_EQ(detector({.rings = false, .ring_ratio_q16 = ratio_q16})->detect(test::view_of(pixels), out), Status::ok);
  }
}

TEST(Detector, SaysSoWhenAFrameHoldsMoreMarksThanItsCapacity) {
  std::mt19937 random(1);
  sim::Renderer renderer(test::kVga, {.clutter = false});
  std::vector<std::uint8_t> pixels;
  renderer.render(test::grid_of_markers(model::MarkerKind::ring, 12, 8, 25, 0, random), 0, pixels);
  const auto full = detector();
  Detections out;
  ASSERT_EQ(full->detect(test::view_of(pixels), out), Status::ok);
  EXPECT_TRUE(out.full());
  EXPECT_TRUE(full->overloaded());

  const std::vector<std::uint8_t> even(640 * 480, 100);
  ASSERT_EQ(full->detect(test::view_of(even), out), Status::ok);
  EXPECT_FALSE(full->overloaded());
}

}  // namespace
}  // namespace articam::vision
