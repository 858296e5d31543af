#include "tests/bits/state_hash.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/bits/bits_run.hpp"

namespace articam::test {
namespace {

using Model = models::PrinterDrawer;

/// Flips every bit of a number, one after the other, and looks whether the hash of the whole changes with each.
template <class Whole, class Number>
void expect_every_bit_counts(const Whole& whole, Number& part) {
  const std::uint64_t before = hash_of(whole);
  auto* bytes = reinterpret_cast<std::uint8_t*>(&part);
  for (std::size_t i = 0; i < 8 * sizeof(Number); ++i) {
    bytes[i / 8] ^= static_cast<std::uint8_t>(1U << i % 8);
    EXPECT_NE(hash_of(whole), before) << "bit " << i;
    bytes[i / 8] ^= static_cast<std::uint8_t>(1U << i % 8);
  }
  EXPECT_EQ(hash_of(whole), before);
}

TEST(StateHash, ChangesWithEveryBitOfADetection) {
  vision::Detections detections;
  for (int i = 0; i < 6; ++i) ASSERT_TRUE(detections.push_back({.outer = {i, 2, 3, 4, 5}, .centre_variance_q24 = 7}));
  for (vision::Detection& detection : detections) {
    expect_every_bit_counts(detections, detection.kind);
    expect_every_bit_counts(detections, detection.flaws);
    expect_every_bit_counts(detections, detection.blur_q8);
    for (std::uint32_t* x : {&detection.centre_variance_q24, &detection.axis_variance_q24,
                             &detection.inner_centre_variance_q24, &detection.inner_axis_variance_q24})
      expect_every_bit_counts(detections, *x);
    for (vision::Ellipse* e : {&detection.outer, &detection.inner}) {
      for (std::int32_t* x : {&e->u_q16, &e->v_q16, &e->m00_q16, &e->m10_q16, &e->m11_q16}) {
        expect_every_bit_counts(detections, *x);
      }
    }
  }
}

TEST(StateHash, ChangesWithTheNumberOfDetectionsAndWithTheirOrder) {
  vision::Detections none, one, two, swapped;
  const vision::Detection first{}, second{.kind = vision::MarkKind::dot_dark_on_light, .centre_variance_q24 = 1};
  ASSERT_TRUE(one.push_back(first));
  ASSERT_TRUE(two.push_back(first) && two.push_back(second));
  ASSERT_TRUE(swapped.push_back(second) && swapped.push_back(first));
  EXPECT_NE(hash_of(none), hash_of(one));
  EXPECT_NE(hash_of(one), hash_of(two));
  EXPECT_NE(hash_of(two), hash_of(swapped));
}

template <class S>
class StateHashOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(StateHashOf, Scalars);

TYPED_TEST(StateHashOf, AnEstimateChangesWithEveryBitOfEachMember) {
  tracker::Estimate<Model, TypeParam> estimate;
  const auto each = [&estimate](auto& numbers) {
    for (auto& x : numbers) expect_every_bit_counts(estimate, x);
  };
  expect_every_bit_counts(estimate, estimate.frame);
  expect_every_bit_counts(estimate, estimate.t_capture.ns);
  expect_every_bit_counts(estimate, estimate.status);
  expect_every_bit_counts(estimate, estimate.reason);
  expect_every_bit_counts(estimate, estimate.matched);
  expect_every_bit_counts(estimate, estimate.rms_px);
  expect_every_bit_counts(estimate, estimate.error_norm);
  expect_every_bit_counts(estimate, estimate.iterations);
  each(estimate.q.T_cam_obj.t);
  each(estimate.q.T_cam_obj.R.coeffs());
  each(estimate.q.joints);
  each(estimate.qdot);
  each(estimate.observability);
  for (TypeParam& x : estimate.covariance.reshaped()) expect_every_bit_counts(estimate, x);
  const std::uint64_t before = hash_of(estimate);
  estimate.valid = !estimate.valid;  // a bool has one bit
  EXPECT_NE(hash_of(estimate), before);
}

std::vector<std::string> lines_with(const Flip& flip) {
  const auto run = std::make_unique<BitsRun>();
  std::vector<std::string> lines;
  run->run(flip, [&lines](const hal::Line& line) { lines.emplace_back(line.text()); });
  return lines;
}

TEST(BitsRun, ShowsTheLowestBitOfOnePixelInDetectionsAndEstimatesFromItsFrameOn) {
  const auto expected = lines_with({}), flipped = lines_with(kEdgeFlip);
  ASSERT_EQ(expected.size(), flipped.size());
  for (std::size_t k = 0; k < kEdgeFlip.frame; ++k) EXPECT_EQ(expected[k], flipped[k]);
  const auto words = [](const std::string& line) {
    std::vector<std::string> all;
    for (std::size_t begin = 0; begin < line.size();) {
      const std::size_t end = line.find_first_of(" \n", begin);
      all.push_back(line.substr(begin, end - begin));
      begin = end + 1;
    }
    return all;
  };
  const auto before = words(expected[kEdgeFlip.frame]), after = words(flipped[kEdgeFlip.frame]);
  for (const std::size_t i_hash : {3U, 5U, 6U, 8U, 9U}) EXPECT_NE(before.at(i_hash), after.at(i_hash)) << i_hash;
  EXPECT_NE(expected[kEdgeFlip.frame + 1], flipped[kEdgeFlip.frame + 1]) << "the state remembers";
}

TEST(BitsRun, HoldsMoreThanAThousandDetections) {
  const std::string last = lines_with({}).back();
  EXPECT_GT(std::stoi(last.substr(last.find(' '))), 1000) << last;
}

}  // namespace
}  // namespace articam::test
