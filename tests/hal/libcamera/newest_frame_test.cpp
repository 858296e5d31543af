#include "hal/libcamera/newest_frame.hpp"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace articam {
namespace {

using namespace std::chrono_literals;
using hal::NewestFrame;

TEST(NewestFrame, IsWhatIsTakenAndTheOneBeforeItGoesBackToItsPoster) {
  NewestFrame newest;
  EXPECT_EQ(newest.take(0ms), NewestFrame::kNone);
  EXPECT_EQ(newest.post(3), NewestFrame::kNone);
  EXPECT_EQ(newest.post(1), 3);
  EXPECT_EQ(newest.take(0ms), 1);
  EXPECT_EQ(newest.take(0ms), NewestFrame::kNone);
}

TEST(NewestFrame, IsNoneForEverOnceClosedUntilItIsReset) {
  NewestFrame newest;
  (void)newest.post(2);
  newest.close();
  newest.close();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(newest.take(0ms), NewestFrame::kClosed);
  newest.reset();
  EXPECT_EQ(newest.take(0ms), NewestFrame::kNone);
  (void)newest.post(1);
  EXPECT_EQ(newest.take(0ms), 1);
}

TEST(NewestFrame, WakesWhoeverWaits) {
  NewestFrame newest;
  std::thread poster{[&] { (void)newest.post(5); }};
  EXPECT_EQ(newest.take(10s), 5);
  poster.join();
  std::thread closer{[&] { newest.close(); }};
  EXPECT_EQ(newest.take(10s), NewestFrame::kClosed);
  closer.join();
}

/// Four buffers go round between two threads that never wait for each other. Each buffer has one owner at a time, or
/// its two halves would be torn (and a thread sanitizer would say so).
TEST(NewestFrame, IsNeverTornNorLostNorOlderThanTheOneBefore) {
  constexpr int kBuffers = 4, kNumFrames = 100'000;
  struct Content {
    int first{}, second{};
  };
  std::array<Content, kBuffers> content{};
  std::array<std::atomic<bool>, kBuffers> is_free;
  for (auto& f : is_free) f = true;
  NewestFrame newest;
  int overtaken = 0, no_buffer = 0;
  std::thread camera{[&] {
    for (int k = 1; k <= kNumFrames; ++k) {
      int buffer = 0;
      while (buffer < kBuffers && !is_free[std::size_t(buffer)].exchange(false)) ++buffer;
      if (buffer == kBuffers) {
        ++no_buffer;
        continue;
      }
      content[std::size_t(buffer)] = {k, k};
      if (const int old = newest.post(buffer); old != NewestFrame::kNone) {
        ++overtaken;
        is_free[std::size_t(old)] = true;
      }
    }
    newest.close();
  }};
  int taken = 0, torn = 0, older = 0, last = 0;
  for (int buffer = 0; (buffer = newest.take(10s)) >= 0; ++taken) {
    const Content c = content[std::size_t(buffer)];
    torn += c.first != c.second;
    older += c.first <= last;
    last = c.first;
    is_free[std::size_t(buffer)] = true;
  }
  camera.join();
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(older, 0);
  const int left = kNumFrames - taken - overtaken - no_buffer;  // in the slot when it was closed
  EXPECT_TRUE(left == 0 || left == 1) << left;
}

}  // namespace
}  // namespace articam
