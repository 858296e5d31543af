#include "core/vision/image_fault.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "host_sim/scenarios/paper.hpp"

namespace articam {
namespace {

using vision::ImageFault;

/// The printer, rendered.
std::vector<std::uint8_t> frame_of(const sim::RenderOptions& options) {
  sim::Renderer renderer{sim::PaperScenario::camera(), options};
  std::vector<std::uint8_t> pixels;
  renderer.render(sim::scene_markers<models::PrinterDrawer>(sim::PaperScenario::at(0).q), 0, pixels);
  return pixels;
}
ImageFault fault_of(const std::vector<std::uint8_t>& pixels) {
  return vision::fault_of(ImageView{pixels.data(), 640, 480, 640});
}

TEST(ImageFault, IsNoneInAnyOrdinaryLight) {
  for (const double exposure : {0.4, 0.7, 1.0, 1.3}) {
    for (const double light_gradient : {1.0, 3.0}) {
      EXPECT_EQ(fault_of(frame_of({.light_gradient = light_gradient, .exposure = exposure})), ImageFault::none)
          << exposure << ' ' << light_gradient;
    }
  }
}

TEST(ImageFault, TellsTooMuchLightFromTooLittle) {
  EXPECT_EQ(fault_of(frame_of({.exposure = 2})), ImageFault::overexposed);
  EXPECT_EQ(fault_of(frame_of({.exposure = 0.1})), ImageFault::underexposed);
}

TEST(ImageFault, SaysBlurredWhereNoEdgeIsSharp) {
  EXPECT_EQ(fault_of(frame_of({.blur_px = 2})), ImageFault::none);  // the clutter has sharper edges than sigma 3
  EXPECT_EQ(fault_of(frame_of({.blur_px = 5})), ImageFault::blurred);
}

TEST(ImageFault, IsNoneOfAnEvenWall) {
  EXPECT_EQ(fault_of(std::vector<std::uint8_t>(640 * 480, 128)), ImageFault::none);
}

TEST(ImageFault, ReadsNothingBetweenTheRows) {
  for (const int width : {1, 7, 8, 100}) {
    const int stride = width + 13, height = 40;
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(stride * height), 255);
    for (int v = 0; v < height; ++v) std::fill_n(pixels.begin() + v * stride, width, std::uint8_t{10});
    EXPECT_EQ(vision::fault_of({pixels.data(), width, height, stride}), ImageFault::underexposed) << width;
  }
}

}  // namespace
}  // namespace articam
