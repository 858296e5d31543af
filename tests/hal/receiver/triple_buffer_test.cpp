#include "hal/receiver/triple_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace articam {
namespace {

TEST(TripleBuffer, GivesTheDefaultUntilSomethingIsPublishedAndThenTheNewest) {
  receiver::TripleBuffer<int> buffer;
  EXPECT_EQ(buffer.newest(), 0);
  for (int i = 1; i < 10; ++i) {
    buffer.back() = i;
    buffer.publish();
  }
  EXPECT_EQ(buffer.newest(), 9);
  EXPECT_EQ(buffer.newest(), 9);
  buffer.back() = 10;
  EXPECT_EQ(buffer.newest(), 9) << "not published yet";
  buffer.publish();
  EXPECT_EQ(buffer.newest(), 10);
}

TEST(TripleBuffer, BetweenTwoThreadsNoValueIsTornAndNoneGoesBack) {
  using Value = std::array<int, 200>;
  constexpr int kLast = 100'000;
  receiver::TripleBuffer<Value> buffer;
  std::thread writer{[&] {
    for (int i = 1; i <= kLast; ++i) {
      buffer.back().fill(i);
      buffer.publish();
    }
  }};
  int before = 0, torn = 0, backwards = 0;
  while (before < kLast) {
    const Value& value = buffer.newest();
    torn += std::ranges::count(value, value[0]) == 200 ? 0 : 1;
    backwards += value[0] < before ? 1 : 0;
    before = value[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(backwards, 0);
}

}  // namespace
}  // namespace articam
