#include "hal/capture/exposure_stamp.hpp"

#include <gtest/gtest.h>

namespace articam {
namespace {

using namespace std::chrono_literals;
using hal::StampMarks;

constexpr auto kExposure = 4ms, kReadout = 10ms;

TEST(MidExposure, IsTheSameWhicheverInstantOfTheFrameWasStamped) {
  constexpr Timestamp kStart{1'000'000'000}, kNow{2'000'000'000};
  const auto mid = [&](StampMarks marks, std::chrono::nanoseconds after_start) {
    return hal::mid_exposure({kStart.ns + after_start.count()}, marks, kExposure, kReadout, kNow);
  };
  EXPECT_EQ(mid(StampMarks::exposure_start, 0ms).ns, kStart.ns + 2'000'000);
  EXPECT_EQ(mid(StampMarks::readout_start, kExposure), mid(StampMarks::exposure_start, 0ms));
  EXPECT_EQ(mid(StampMarks::readout_end, kExposure + kReadout), mid(StampMarks::exposure_start, 0ms));
}

TEST(MidExposure, IsNeverOfTheFuture) {
  EXPECT_EQ(hal::mid_exposure({50}, StampMarks::exposure_start, kExposure, 0ms, Timestamp{60}).ns, 60);
}

TEST(IsOfThisClock, TakesStampsFromNowBackToTheGreatestAge) {
  constexpr Timestamp kNow{5'000'000'000};
  EXPECT_TRUE(hal::is_of_this_clock(kNow, kNow, 1s));
  EXPECT_TRUE(hal::is_of_this_clock({4'000'000'000}, kNow, 1s));
  EXPECT_FALSE(hal::is_of_this_clock({3'999'999'999}, kNow, 1s));
  EXPECT_FALSE(hal::is_of_this_clock({5'000'000'001}, kNow, 1s));
  EXPECT_FALSE(hal::is_of_this_clock({INT64_MIN}, kNow, 1s));
}

}  // namespace
}  // namespace articam
