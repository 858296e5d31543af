#include "host_sim/world/gaussian_blur.hpp"

#include <gtest/gtest.h>

namespace articam::sim {
namespace {

constexpr PixelBox kWhole{0, 0, 80, 80};

struct Moments {
  double sum{}, variance_u{}, variance_v{};
};

Moments moments_about_the_centre(const GreyPlane& plane) {
  Moments m;
  for (int v = 0; v < plane.height_px; ++v) {
    for (int u = 0; u < plane.width_px; ++u) {
      const double grey = plane.row(v)[u];
      m.sum += grey, m.variance_u += grey * (u - 40) * (u - 40), m.variance_v += grey * (v - 40) * (v - 40);
    }
  }
  m.variance_u /= m.sum, m.variance_v /= m.sum;
  return m;
}

TEST(GaussianBlur, SpreadsAPointByItsSigmaAndKeepsItsLight) {
  for (const double sigma_px : {0.7, 1.5, 3.0}) {
    GreyPlane point{81, 81, 0}, soft{81, 81, 0};
    for (int v = 38; v <= 42; ++v) {
      for (int u = 38; u <= 42; ++u) point.row(v)[u] = kMaxGrey_q6;  // bright enough that rounding counts little
    }
    GaussianBlur{sigma_px}.apply(point, kWhole, soft);
    const Moments before = moments_about_the_centre(point), after = moments_about_the_centre(soft);
    EXPECT_NEAR(after.sum / before.sum, 1, 1e-3) << "each pixel is rounded to 1/64 grey";
    // A sampled Gaussian of sigma >= 0.7 has the variance of the continuous one to 0.3 %; rounding adds as much.
    EXPECT_NEAR(after.variance_u - before.variance_u, sigma_px * sigma_px, 0.01 * sigma_px * sigma_px);
    EXPECT_NEAR(after.variance_v - before.variance_v, sigma_px * sigma_px, 0.01 * sigma_px * sigma_px);
  }
}

TEST(GaussianBlur, LeavesAFlatAreaAndItsBordersAlone) {
  const GreyPlane flat{81, 81, grey_q6(137)};
  GreyPlane soft{81, 81, 0};
  GaussianBlur{2.3}.apply(flat, kWhole, soft);
  EXPECT_EQ(soft.q6, flat.q6);
}

TEST(GaussianBlur, CopiesWhenSigmaIsZero) {
  GreyPlane image{81, 81, 0}, out{81, 81, 0};
  for (std::size_t i = 0; i < image.q6.size(); ++i) image.q6[i] = static_cast<std::int16_t>(i * 37 % 16320);
  GaussianBlur{0}.apply(image, kWhole, out);
  EXPECT_EQ(out.q6, image.q6);
}

TEST(GaussianBlur, OfABoxEqualsThatPartOfTheWhole) {
  GreyPlane image{81, 81, 0}, whole{81, 81, 0}, part{81, 81, 0};
  for (std::size_t i = 0; i < image.q6.size(); ++i) image.q6[i] = static_cast<std::int16_t>(i * i % 16320);
  GaussianBlur blur{1.1};
  blur.apply(image, kWhole, whole);
  blur.apply(image, {3, 50, 30, 80}, part);
  for (int v = 50; v <= 80; ++v) {
    for (int u = 3; u <= 30; ++u) EXPECT_EQ(part.row(v)[u], whole.row(v)[u]);
  }
}

}  // namespace
}  // namespace articam::sim
