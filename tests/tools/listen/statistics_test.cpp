#include "tools/listen/statistics.hpp"

#include <gtest/gtest.h>

#include <string>

namespace articam::listen {
namespace {

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(Statistics, SayWhatTheTimesAreWorth) {
  Statistics statistics;
  statistics.capture_to_send.take(0.004);
  statistics.send_to_receipt.take(0.0002);
  EXPECT_TRUE(says(table(statistics), "one machine, one clock"));
  statistics.exact = false;
  EXPECT_TRUE(says(table(statistics), "beyond the quickest packet"));
  EXPECT_TRUE(says(table(statistics), "4.000"));
  EXPECT_TRUE(says(status_line(statistics), "send -> receipt 0.200"));
}

TEST(Statistics, GiveLossAsAShareOfWhatWasSent) {
  Statistics statistics;
  EXPECT_TRUE(says(table(statistics), "lost        0 (0.000 %)")) << "of nothing";
  statistics.estimates = {.received = 199, .lost = 1, .duplicates = 3, .reordered = 4};
  EXPECT_TRUE(says(table(statistics), "lost        1 (0.500 %)"));
  EXPECT_TRUE(says(status_line(statistics), "lost 1 (0.50 %)  duplicates 3  reordered 4"));
}

TEST(Statistics, CountBrokenFramesOfASerialLineAsBad) {
  Statistics statistics;
  statistics.broken_frames = 2;
  EXPECT_EQ(statistics.bad(), 2u);
  EXPECT_TRUE(says(table(statistics), "bad         2: broken_frame 2"));
}

}  // namespace
}  // namespace articam::listen
