/// @file  What becomes of the buffers between the library, the loop and the way back.

#include "hal/libcamera/libcamera_camera.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "tests/hal/libcamera/camera_on_script.hpp"
#include "tests/support/heap_trap.hpp"

namespace articam {
namespace {

using namespace std::chrono_literals;
using Health = hal::CompletedBuffer::Health;
using test::kWidth_px;

class LibcameraBuffers : public test::CameraOnScript {};

TEST_F(LibcameraBuffers, LendsLumaInPlaceWithTheStrideOfTheCamera) {
  ASSERT_EQ(camera->start(), Status::ok);
  ASSERT_TRUE(device->complete(7));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_TRUE(std::ranges::any_of(device->memory, [&](auto& bytes) { return bytes.data() == frame.pixels.data; }));
  EXPECT_EQ(frame.pixels.stride_bytes, kWidth_px * 4 + 32);
  EXPECT_EQ(frame.sequence, 7u);
  EXPECT_TRUE(device->has_free(3));  // the lent buffer is not the camera's
  camera->release(frame);
  EXPECT_TRUE(device->has_free(4));
  EXPECT_EQ(camera->counts().copied, 0u);
}

TEST_F(LibcameraBuffers, CopiesGreenOnlyWhereNothingBetterIsOfferedAndSaysSo) {
  device->abilities.formats = {hal::fourcc("MJPG"), hal::fourcc("BG24")};
  ASSERT_EQ(camera->start(), Status::ok) << camera->problem();
  EXPECT_NE(camera->description().find("GREEN COPIED"), std::string::npos) << camera->description();
  for (auto& bytes : device->memory) {
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = i % 3 == 1 ? 50 : 0;  // rows are not a multiple of 3
  }
  ASSERT_TRUE(device->complete(1));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_EQ(frame.pixels.stride_bytes, kWidth_px);
  for (int u = 0; u < kWidth_px; ++u) EXPECT_EQ(frame.pixels.row(0)[u], 50);
  EXPECT_TRUE(device->has_free(4));  // the camera has its buffer back at once
  EXPECT_EQ(camera->counts().copied, 1u);
}

TEST_F(LibcameraBuffers, TheNewestFrameWinsAndTheOthersAreCountedAndGivenBack) {
  ASSERT_EQ(camera->start(), Status::ok);
  for (std::uint32_t k = 1; k <= 100; ++k) ASSERT_TRUE(device->complete(k));
  ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
  EXPECT_EQ(frame.sequence, 100u);
  EXPECT_EQ(camera->counts().overtaken, 99u);
  EXPECT_TRUE(device->has_free(3));
  camera->release(frame);
}

TEST_F(LibcameraBuffers, GivesBuffersBackFromAThreadOfItsOwnSoThatTheLoopNeverWaitsForTheLibrary) {
  for (const auto format : {hal::fourcc("NV12"), hal::fourcc("YUYV")}) {
    device->abilities.formats = {format};
    ASSERT_EQ(camera->start(), Status::ok);
    ASSERT_TRUE(device->complete(1));
    ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
    camera->release(frame);
    ASSERT_TRUE(device->has_free(4));
    EXPECT_NE(device->queuer.load(), std::this_thread::get_id());
  }
}

TEST_F(LibcameraBuffers, IsNotStarvedWhereEveryBufferIsOutAndNoneComesBack) {
  make({.buffers = 2});
  ASSERT_EQ(camera->start(), Status::ok);
  for (std::uint32_t k = 1; k <= 100; ++k) {
    ASSERT_TRUE(device->complete(k));  // none would be left after two
    ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
    EXPECT_EQ(frame.sequence, k);
    camera->release(frame);
  }
}

TEST_F(LibcameraBuffers, LosesNoFrameUncountedBetweenThreeThreads) {
  constexpr std::uint32_t kNumFrames = 20'000;
  ASSERT_EQ(camera->start(), Status::ok);
  std::thread captures{[this] {
    for (std::uint32_t k = 1; k <= kNumFrames; ++k) EXPECT_TRUE(device->complete(k));
  }};
  std::uint64_t taken = 0;
  for (std::uint32_t last = 0; last < kNumFrames; ++taken) {
    ASSERT_EQ(camera->acquire(frame, 10s), Status::ok) << camera->problem();
    EXPECT_GT(frame.sequence, last);
    last = frame.sequence;
    camera->release(frame);
  }
  captures.join();
  const hal::CaptureCounts counts = camera->counts();
  EXPECT_EQ(taken + counts.overtaken + counts.out_of_order, kNumFrames);
  EXPECT_TRUE(device->has_free(4));
}

TEST_F(LibcameraBuffers, ReadsEachFrameBetweenItsTwoMarks) {
  for (const auto format : {hal::fourcc("NV12"), hal::fourcc("YUYV")}) {
    device->abilities.formats = {format};
    device->reads = 0;
    ASSERT_EQ(camera->start(), Status::ok);
    ASSERT_TRUE(device->complete(1));
    ASSERT_EQ(camera->acquire(frame, 0ms), Status::ok);
    const bool is_copy = format == hal::fourcc("YUYV");
    EXPECT_EQ(device->being_read >= 0, !is_copy);
    camera->release(frame);
    EXPECT_EQ(device->being_read, -1);
    EXPECT_EQ(device->reads, 1);
  }
}

TEST_F(LibcameraBuffers, NeverCallsTheHeapBetweenStartAndStop) {
  if (!test::HeapTrap::works()) GTEST_SKIP() << "the heap cannot be replaced here (sanitizers bring their own)";
  const std::function<void(hal::CompletedBuffer&)> corrupt = [](auto& b) { b.health = Health::corrupt; };
  for (const auto format : {hal::fourcc("NV12"), hal::fourcc("YUYV")}) {
    device->abilities.formats = {format};
    ASSERT_EQ(camera->start(), Status::ok);
    int taken = 0;
    const test::HeapTrap trap;
    for (std::uint32_t k = 0; k < 400; k += 4) {
      (void)device->complete(k);
      (void)device->complete(k + 1, corrupt);
      (void)device->complete(k + 2);  // overtakes the first
      taken += camera->acquire(frame, 0ms) == Status::ok;
      camera->release(frame);
      (void)camera->acquire(frame, 0ms);  // a timeout
    }
    device->unplug();
    (void)camera->acquire(frame, 0ms);
    EXPECT_EQ(trap.calls(), 0);
    EXPECT_EQ(taken, 100);
    device->plugged_in = true;
  }
}

}  // namespace
}  // namespace articam
