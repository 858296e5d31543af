#include "core/vision/point_symmetry.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/types.hpp"
#include "core/vision/fixed_point.hpp"
#include "tests/support/random_state.hpp"

// A dark ellipse so blurred that it has no edges left: 200 - 150 exp(-|M^-1 (x - c)|^2 / (2 kWidth^2)).
namespace articam {
namespace {

using vision::Centre;
using vision::EdgeFit;
using vision::kOne_q16;

constexpr std::int32_t kRatio_q16 = 26859;
constexpr double kWidth = 0.45, kNoise_grey = 4;
const Vec<double, 2> kCentre_px{40.3, 31.8};

std::int32_t q16(double px) { return static_cast<std::int32_t>(std::lround(px * 65536)); }

Mat<double, 2, 2> axes() { return (Mat<double, 2, 2>{} << 9, 0, 2, 8).finished(); }

/// What may be odd about it: light that grows by `gain` of it in a radius along the first axis; lines of equal grey of
/// radius r that lie (1 - r^2) of `offset` from the centre, radii.
struct Oddities {
  double gain = 0;
  Vec<double, 2> offset = Vec<double, 2>::Zero();
};

struct Blob {
  static constexpr int kSize_px = 80;
  std::vector<std::uint8_t> pixels;

  explicit Blob(test::Random* noise, const Oddities& odd = {}) : pixels(kSize_px * kSize_px) {
    const Mat<double, 2, 2> in_radii = axes().inverse();
    for (int v = 0; v < kSize_px; ++v)
      for (int u = 0; u < kSize_px; ++u) {
        const Vec<double, 2> x = in_radii * (Vec<double, 2>(u, v) - kCentre_px);
        double r = x.norm();
        for (int i = 0; i < 8; ++i) r = r < 2 ? (x - (1 - r * r) * odd.offset).norm() : r;
        const double grey = (200 - 150 * std::exp(-r * r / (2 * kWidth * kWidth))) * (1 + odd.gain * x.x());
        const double seen = grey + (noise != nullptr ? kNoise_grey * noise->gaussian() : 0);
        pixels[static_cast<std::size_t>(v * kSize_px + u)] =
            static_cast<std::uint8_t>(std::lround(std::clamp(seen, 0.0, 255.0)));
      }
  }
  ImageView view() const { return {pixels.data(), kSize_px, kSize_px, kSize_px}; }
};

EdgeFit blurred_edge() {
  EdgeFit outer;
  outer.ellipse = {q16(40), q16(32), q16(axes()(0, 0)), q16(axes()(1, 0)), q16(axes()(1, 1))};
  outer.blur_q8 = 4 * 256;
  return outer;
}

Centre at(double u_px, double v_px) {
  Centre centre;
  centre.u_q16 = q16(u_px), centre.v_q16 = q16(v_px);
  centre.variance_q24 = 1 << 20;
  centre.edges_agree = true;
  return centre;
}

Vec<double, 2> place(const Centre& c) { return {vision::from_q16(c.u_q16), vision::from_q16(c.v_q16)}; }

/// Returns what it cost.
int weigh(const Blob& blob, const EdgeFit& outer, Centre& io) {
  int budget = 0;
  weigh_symmetry(blob.view(), outer, kRatio_q16, budget, io);
  return -budget;
}

TEST(PointSymmetry, FindsTheMiddleOfWhatHasNoEdges) {
  Centre centre = at(40.15, 31.95);
  weigh(Blob{nullptr}, blurred_edge(), centre);
  EXPECT_LT((place(centre) - kCentre_px).norm(), 0.01);
  weigh(Blob{nullptr}, blurred_edge(), centre);
  EXPECT_LT((place(centre) - kCentre_px).norm(), 0.002);
}

// What no unbiased estimate falls below: grad I grad I^T / noise^2, summed over the pixels within 1.1 radii.
TEST(PointSymmetry, ErrsAsLittleAsNoiseAllows) {
  const Mat<double, 2, 2> in_radii = axes().inverse();
  Mat<double, 2, 2> information = Mat<double, 2, 2>::Zero();
  for (int v = 0; v < Blob::kSize_px; ++v)
    for (int u = 0; u < Blob::kSize_px; ++u) {
      const Vec<double, 2> x = in_radii * (Vec<double, 2>(u, v) - kCentre_px);
      if (x.norm() > 1.1) continue;
      const Vec<double, 2> slope =
          150 * std::exp(-x.squaredNorm() / (2 * kWidth * kWidth)) / (kWidth * kWidth) * (in_radii.transpose() * x);
      information += slope * slope.transpose() / (kNoise_grey * kNoise_grey);
    }
  const double bound_px = std::sqrt(information.inverse().trace());

  test::Random random{11};
  double squared = 0, normalised = 0;
  constexpr int kTrials = 600;
  for (int i = 0; i < kTrials; ++i) {
    Centre centre = at(kCentre_px.x() + 0.02 * random.gaussian(), kCentre_px.y() + 0.02 * random.gaussian());
    weigh(Blob{&random}, blurred_edge(), centre);
    const double square = (place(centre) - kCentre_px).squaredNorm();
    squared += square, normalised += square / 2 / (centre.variance_q24 / 16777216.0);
  }
  EXPECT_NEAR(std::sqrt(squared / kTrials) / bound_px, 1.05, 0.08);
  EXPECT_NEAR(normalised / kTrials, 1.1, 0.4);  // its share of noise was found with rings
}

// Light that grows by a tenth in a radius moves what is taken for the middle in even light.
TEST(PointSymmetry, TellsLightFromAShift) {
  const Blob blob{nullptr, {.gain = 0.1}};
  Centre even = at(40.15, 31.95), uneven = even, half = even;
  uneven.uneven_q16 = kOne_q16, half.uneven_q16 = kOne_q16 / 2;
  weigh(blob, blurred_edge(), even);
  weigh(blob, blurred_edge(), uneven);
  weigh(blob, blurred_edge(), half);
  EXPECT_GT((place(even) - kCentre_px).norm(), 0.1);
  EXPECT_LT((place(uneven) - kCentre_px).norm(), 0.012);
  EXPECT_LT((place(half) - (place(even) + place(uneven)) / 2).norm(), 0.001);
  EXPECT_GT(half.variance_q24 / 16777216.0, (place(half) - kCentre_px).squaredNorm() / 2);  // it is one or the other
}

TEST(PointSymmetry, IsNotAskedWhereEdgesAreNarrowHiddenOrDisagree) {
  const Vec<double, 2> before{40.15, 31.95};
  EdgeFit sharp = blurred_edge(), hidden = sharp;
  sharp.blur_q8 = 128, hidden.flaws = vision::kOccluded;
  Centre centre = at(before.x(), before.y()), apart = centre, far = centre;
  for (const EdgeFit& outer : {sharp, hidden}) {
    EXPECT_EQ(weigh(Blob{nullptr}, outer, centre), 0);
    EXPECT_EQ(place(centre), place(at(before.x(), before.y())));
  }
  apart.edges_agree = false;
  far.hole_q24 = {(1 << 24) / 16, 0};  // 0.56 px
  for (Centre unknown : {apart, far}) {
    EXPECT_EQ(weigh(Blob{nullptr}, blurred_edge(), unknown), 0);
    EXPECT_EQ(place(unknown), place(at(before.x(), before.y())));
    EXPECT_EQ(unknown.variance_q24, 1u << 20);
  }
}

// Perspective parts circles; whoever does not know by how much takes a third of it for a move.
TEST(PointSymmetry, GoesByWhereTheHoleIs) {
  const double ratio = kRatio_q16 / 65536.0;
  const Vec<double, 2> hole{0.04, -0.02};  // radii
  const Blob blob{nullptr, {.offset = hole / (1 - ratio * ratio)}};
  Centre told = at(40.15, 31.95), untold = told, unsure = told;
  told.hole_q24 = {std::llround(hole.x() * 16777216), std::llround(hole.y() * 16777216)};
  unsure.hole_q24 = told.hole_q24, unsure.hole_variance_q40 = std::int64_t{1} << 27;  // 0.008 radii of each coordinate
  for (Centre* centre : {&told, &untold, &unsure}) weigh(blob, blurred_edge(), *centre);
  EXPECT_LT((place(told) - kCentre_px).norm(), 0.015);
  EXPECT_GT((place(untold) - kCentre_px).norm(), 0.15);
  EXPECT_EQ(place(unsure), place(told));
  const double more_px = std::sqrt((unsure.variance_q24 - told.variance_q24) / 16777216.0);
  EXPECT_GT(more_px, 0.008 * 8 * 0.2);
  EXPECT_LT(more_px, 0.008 * 9 * 0.8);
}

TEST(PointSymmetry, CostsTwoReadingsAndInUnevenLightThree) {
  Centre even = at(40.15, 31.95), uneven = even;
  uneven.uneven_q16 = kOne_q16 / 4;
  const int reading = (vision::kRaysPerPass + 64) * vision::kLooksPerRay;
  EXPECT_EQ(weigh(Blob{nullptr}, blurred_edge(), even), 2 * reading);
  EXPECT_EQ(weigh(Blob{nullptr}, blurred_edge(), uneven), 3 * reading);
}

// Something bright before one side of it: the rest grows, and with it the variance. Beyond what the edges claim, and
// far from their answer, it is theirs that counts.
TEST(PointSymmetry, OfWhatIsNotSymmetricIsUnsureOrNotAsked) {
  test::Random noise{3};
  Blob blob{&noise};
  Centre whole = at(40.2, 31.9), hidden = whole, claimed = whole, far = at(40.9, 31.8);
  weigh(blob, blurred_edge(), whole);
  for (int v = 30; v < 34; ++v)
    for (int u = 44; u < 48; ++u) blob.pixels[static_cast<std::size_t>(v * Blob::kSize_px + u)] = 200;
  weigh(blob, blurred_edge(), hidden);
  EXPECT_GT(hidden.variance_q24, 5 * whole.variance_q24);

  const Vec<double, 2> before = place(claimed);
  claimed.variance_q24 = hidden.variance_q24 / 3;
  weigh(blob, blurred_edge(), claimed);
  EXPECT_EQ(place(claimed), before);
  far.variance_q24 = 1 << 13;  // 0.02 px
  weigh(Blob{nullptr}, blurred_edge(), far);
  EXPECT_EQ(place(far), place(at(40.9, 31.8)));
}

TEST(PointSymmetry, OfAFlatImageChangesNothing) {
  Blob blob{nullptr};
  std::fill(blob.pixels.begin(), blob.pixels.end(), std::uint8_t{90});
  Centre centre = at(40.15, 31.95);
  weigh(blob, blurred_edge(), centre);
  EXPECT_EQ(place(centre), place(at(40.15, 31.95)));
  EXPECT_EQ(centre.variance_q24, 1u << 20);
}

}  // namespace
}  // namespace articam
