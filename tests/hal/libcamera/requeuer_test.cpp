#include "hal/libcamera/requeuer.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace articam {
namespace {

using namespace std::chrono_literals;

TEST(Requeuer, QueuesOnAThreadOfItsOwnAndWaitsForNoNextBuffer) {
  hal::Requeuer requeuer;
  hal::Semaphore queued;
  int buffer = -1;
  std::thread::id queuer;
  requeuer.start([&](int i) {
    buffer = i;
    queuer = std::this_thread::get_id();
    queued.post();
  });
  for (const int i : {0, 5, hal::Requeuer::kMaxBuffers - 1}) {
    requeuer.give_back(i);
    ASSERT_TRUE(queued.wait(10s));  // one alone: no other buffer pushes it on
    EXPECT_EQ(buffer, i);
    EXPECT_NE(queuer, std::this_thread::get_id());
  }
}

TEST(Requeuer, KeepsWhatIsGivenBackWhileTheLibraryIsSlow) {
  hal::Requeuer requeuer;
  hal::Semaphore entered, go_on, queued;
  std::uint32_t buffers = 0;
  requeuer.start([&](int i) {
    entered.post();
    go_on.wait();
    buffers |= 1u << i;
    queued.post();
  });
  requeuer.give_back(0);
  ASSERT_TRUE(entered.wait(10s));
  for (const int i : {1, 2, 3}) requeuer.give_back(i);  // does not wait, though the library does
  for (int i = 0; i < 4; ++i) go_on.post();
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(queued.wait(10s));
  EXPECT_EQ(buffers, 0b1111u);
}

TEST(Requeuer, ForgetsOnStopWhatWasNotQueuedAndCanBeStartedAgain) {
  hal::Requeuer requeuer;
  requeuer.stop();
  for (int run = 0; run < 3; ++run) {
    hal::Semaphore queued;
    requeuer.start([&](int) { queued.post(); });
    requeuer.give_back(1);
    ASSERT_TRUE(queued.wait(10s));
    requeuer.stop();
    requeuer.stop();
    EXPECT_FALSE(queued.wait(0ms));
  }
}

}  // namespace
}  // namespace articam
