#include "core/vision/concentric.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/types.hpp"
#include "tests/core/vision/marker_scene.hpp"
#include "tests/support/random_state.hpp"

namespace articam {
namespace {

using vision::EdgeFit;

constexpr std::int32_t kRatio_q16 = 26859;
constexpr double kRatio = kRatio_q16 / 65536.0;
constexpr double kSigma_px = 0.02;  // of the outer edge's centre; the hole's has its square times 1 / ratio

std::int32_t q16(double px) { return static_cast<std::int32_t>(std::lround(px * 65536)); }
std::int64_t q40(double squared_radii) { return std::llround(squared_radii * 1099511627776.0); }

/// A round ring of 10 px that light has moved by `light_px`, in edges that err by so much.
struct Fits {
  EdgeFit outer, hole;
};
Fits fits(const Vec<double, 2>& light_px, const Vec<double, 2>& outer_error_px, const Vec<double, 2>& hole_error_px,
          const Vec<double, 2>& light_error_px, double light_sigma_px) {
  constexpr double kRadius_px = 10, kU_px = 319.5, kV_px = 239.5;  // in the middle: the hole is at the same place
  const auto edge = [](double radius_px, const Vec<double, 2>& place) {
    EdgeFit fit;
    fit.ellipse = {q16(kU_px), q16(kV_px), q16(radius_px), 0, q16(radius_px)};
    fit.plain_u_q16 = q16(kU_px + place.x()), fit.plain_v_q16 = q16(kV_px + place.y());
    fit.contrast_q4 = 185 * 16;
    fit.axis_variance_q24 = 1;
    return fit;
  };
  Fits both{edge(kRadius_px, outer_error_px - light_px), edge(kRadius_px * kRatio, hole_error_px + kRatio * light_px)};
  const Vec<double, 2> seen = (light_px + light_error_px) / kRadius_px;
  both.outer.light_q24 = {std::llround(seen.x() * 16777216), std::llround(seen.y() * 16777216)};
  both.outer.plain_variance_q40 = q40(std::pow(kSigma_px / kRadius_px, 2));
  both.outer.light_variance_q40 = q40(std::pow(light_sigma_px / kRadius_px, 2));
  both.outer.centre_variance_q24 = static_cast<std::uint32_t>(std::pow(kSigma_px, 2) * 16777216);
  return both;
}

struct Score {
  double rms_px, normalised;
};
Score score(const Vec<double, 2>& light_px, double light_sigma_px) {
  test::Random random{5};
  const vision::Pinhole camera = vision::pinhole_of(test::kVga);
  double squared = 0, normalised = 0;
  constexpr int kTrials = 4000;
  for (int i = 0; i < kTrials; ++i) {
    const auto error = [&random](double sigma) {
      return Vec<double, 2>{random.gaussian() * sigma, random.gaussian() * sigma};
    };
    const Fits both =
        fits(light_px, error(kSigma_px), error(kSigma_px / std::sqrt(kRatio)), error(light_sigma_px), light_sigma_px);
    vision::Centre centre;
    EXPECT_TRUE(vision::join_centres(both.outer, both.hole, camera, kRatio_q16, centre));
    const double square =
        std::pow(vision::from_q16(centre.u_q16) - 319.5, 2) + std::pow(vision::from_q16(centre.v_q16) - 239.5, 2);
    squared += square, normalised += square / 2 / (centre.variance_q24 / 16777216.0);
  }
  return {std::sqrt(squared / kTrials / 2), normalised / kTrials};
}

// Without light, two measurements with weights 1 and k: 1 / sqrt(1 + k) of the better one's error.
TEST(JoinedCentres, InEvenLightAreTheMeanOfBothEdges) {
  const Score even = score(Vec<double, 2>::Zero(), 0.02);
  EXPECT_LT(even.rms_px,
            kSigma_px * 1.1 / std::sqrt(1 + kRatio));  // a light that is only noise is believed now and then
  EXPECT_NEAR(even.normalised, 1, 0.15);
}

// With l = x to its noise s, least squares leave  C / (A C - B^2)  of the outer edge's variance.
TEST(JoinedCentres, InUnevenLightAreLeastSquares) {
  for (const double light_sigma_px : {0.01, 0.02, 0.04}) {
    const double l = std::pow(kSigma_px / light_sigma_px, 2), h = kRatio;
    const double A = 1 + h, B = -1 + kRatio * h, C = 1 + kRatio * kRatio * h + l;
    const Score uneven = score({0.3, -0.2}, light_sigma_px);
    EXPECT_NEAR(uneven.rms_px / (kSigma_px * std::sqrt(C / (A * C - B * B))), 1, 0.03) << light_sigma_px;
    EXPECT_NEAR(uneven.normalised, 1, 0.12) << light_sigma_px;
  }
}

TEST(JoinedCentres, LeaveAHoleThatIsElsewhereOutAndSaySo) {
  const Vec<double, 2> zero = Vec<double, 2>::Zero();
  const vision::Pinhole camera = vision::pinhole_of(test::kVga);
  vision::Centre centre;
  Fits both = fits(zero, zero, {0.5, 0}, zero, 0.02);
  both.outer.ellipse.u_q16 += 1000;  // what the outer edge's fit believes, its plain place aside
  EXPECT_TRUE(vision::join_centres(both.outer, both.hole, camera, kRatio_q16, centre));
  EXPECT_EQ(centre.u_q16, both.outer.ellipse.u_q16);
  EXPECT_EQ(centre.v_q16, both.outer.ellipse.v_q16);
  EXPECT_NEAR(std::sqrt(centre.variance_q24 / 16777216.0), 0.5 / std::sqrt(2), 0.02);
}

// The widest lens that counts as known shows a ring of half the frame: offsets of several radii, known badly.
TEST(JoinedCentres, OfAWideLensAndALargeRingStayInTheirRange) {
  const Vec<double, 2> zero = Vec<double, 2>::Zero();
  Fits both = fits(zero, zero, zero, zero, 0.02);
  for (EdgeFit* fit : {&both.outer, &both.hole}) {
    fit->ellipse.m00_q16 = fit->ellipse.m11_q16 = q16(fit == &both.outer ? 230 : 230 * kRatio);
    fit->ellipse.m10_q16 = q16(20);
    fit->plain_variance_q40 = q40(4e-4 / 32);
  }
  const vision::Pinhole widest{vision::kMinFocal_q16, q16(319.5), q16(239.5), 0};
  vision::Centre centre;
  EXPECT_TRUE(vision::join_centres(both.outer, both.hole, widest, kRatio_q16, centre));
  EXPECT_GE(centre.hole_variance_q40, 0);
  EXPECT_NEAR(vision::from_q16(centre.u_q16), 319.5, 1);
  EXPECT_NEAR(vision::from_q16(centre.v_q16), 239.5, 1);
}

TEST(JoinedCentres, OfEdgesATenthOfARadiusApartAreNone) {
  const Vec<double, 2> zero = Vec<double, 2>::Zero();
  const Fits both = fits(zero, zero, {1.1, 0}, zero, 0.02);
  vision::Centre centre;
  EXPECT_FALSE(vision::join_centres(both.outer, both.hole, vision::pinhole_of(test::kVga), kRatio_q16, centre));
}

}  // namespace
}  // namespace articam
