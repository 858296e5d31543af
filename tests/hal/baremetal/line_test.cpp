#include "hal/baremetal/line.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace articam::hal {
namespace {

TEST(Line, WritesIntegersAsTheStandardLibraryDoes) {
  for (const std::int64_t x : {std::int64_t{0}, std::int64_t{7}, std::int64_t{-10}, std::int64_t{1234567890123},
                               std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
    EXPECT_EQ((Line{} << x).text(), std::to_string(x));
  }
  EXPECT_EQ((Line{} << std::numeric_limits<std::uint64_t>::max()).text(), "18446744073709551615");
}

TEST(Line, PadsHexadecimalAndDecimalNumbersWithZeros) {
  EXPECT_EQ((Line{} << hex(0xABCU)).text(), "00000abc");
  EXPECT_EQ((Line{} << hex(std::uint64_t{1} << 63)).text(), "8000000000000000");
  EXPECT_EQ((Line{} << "frame_" << decimal(42, 6) << '.').text(), "frame_000042.");
}

TEST(Line, LeavesOutWhatDoesNotFitAndStillEndsWithAZero) {
  Line line;
  for (int i = 0; i < 1000; ++i) line << 'x';
  EXPECT_EQ(line.text().size(), 255U);
  EXPECT_EQ(std::string{line.c_str()}, std::string(255, 'x'));
}

}  // namespace
}  // namespace articam::hal
