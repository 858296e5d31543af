#include "tools/listen/clock_map.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/random_state.hpp"

namespace articam::listen {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

TEST(ClockMap, NeverMapsASendingBehindItsReceipt) {
  test::Random random{6};
  ClockMap map;
  for (std::int64_t sent = 0; sent < 200 * kSecond_ns; sent += kSecond_ns / 30) {
    const auto way = static_cast<std::int64_t>(random.uniform(1e5, 2e7));
    map.take(sent, sent + 77 * kSecond_ns + way);
    ASSERT_LE(map.to_host_ns(sent), sent + 77 * kSecond_ns + way) << "seed 6";
    ASSERT_GE(map.to_host_ns(sent), sent + 77 * kSecond_ns) << "seed 6";
  }
}

TEST(ClockMap, FollowsADriftAndAClockThatWasSetWithinAMinute) {
  ClockMap map;
  std::int64_t sent = 0;
  for (; sent < 600 * kSecond_ns; sent += kSecond_ns / 10) map.take(sent, sent + sent / 10'000);  // 100 ppm, growing
  EXPECT_LE(sent / 10'000 - map.offset_ns(), 60 * kSecond_ns / 10'000) << "a minute's drift";
  for (const std::int64_t step : {kSecond_ns, -kSecond_ns}) {
    for (const std::int64_t end = sent + 61 * kSecond_ns; sent < end; sent += kSecond_ns / 10)
      map.take(sent, sent + step);
    EXPECT_EQ(map.offset_ns(), step);
  }
}

TEST(ClockMap, WrapsWithTimesThatNoClockShows) {
  ClockMap map;
  map.take(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(map.to_host_ns(std::numeric_limits<std::int64_t>::min()), std::numeric_limits<std::int64_t>::max());
}

}  // namespace
}  // namespace articam::listen
