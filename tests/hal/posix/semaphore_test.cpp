#include "hal/posix/semaphore.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace articam {
namespace {

using namespace std::chrono_literals;

TEST(Semaphore, LetsOneWaitPassForEachPostInWhicheverOrderTheyCome) {
  hal::Semaphore semaphore;
  EXPECT_FALSE(semaphore.wait(0ms));
  semaphore.post();
  semaphore.post();
  EXPECT_TRUE(semaphore.wait(0ms));
  semaphore.wait();
  EXPECT_FALSE(semaphore.wait(1ms));
}

TEST(Semaphore, WakesWhoeverWaitsAndShowsWhatWasWrittenBeforeThePost) {
  hal::Semaphore semaphore;
  int written = 0;
  std::thread other{[&] {
    written = 7;
    semaphore.post();
  }};
  ASSERT_TRUE(semaphore.wait(10s));
  EXPECT_EQ(written, 7);
  other.join();
}

TEST(Semaphore, ForgetsWhatWasPostedWhenItIsCleared) {
  hal::Semaphore semaphore;
  for (int i = 0; i < 3; ++i) semaphore.post();
  semaphore.clear();
  EXPECT_FALSE(semaphore.wait(0ms));
}

}  // namespace
}  // namespace articam
