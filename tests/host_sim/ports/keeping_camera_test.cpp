#include "host_sim/ports/keeping_camera.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace articam::sim {
namespace {

/// Lends the same pixel again and again, and counts who has it.
struct OnePixelCamera {
  Status start() noexcept { return Status::ok; }
  void stop() noexcept {}
  Status acquire(hal::Frame& out, std::chrono::milliseconds) noexcept {
    out = {{&pixel, 1, 1, 1}, {}, next++};
    ++lent;
    return Status::ok;
  }
  void release(hal::Frame& frame) noexcept {
    frame = {};
    --lent;
  }

  std::uint8_t pixel{7};
  std::uint32_t next{};
  int lent{};
};
static_assert(hal::CameraPort<KeepingCamera<OnePixelCamera>>);

TEST(KeepingCamera, ShowsEachFrameThatItLends) {
  OnePixelCamera inner;
  std::vector<std::uint32_t> kept;
  KeepingCamera<OnePixelCamera> camera{inner, [&](const hal::Frame& frame, std::string&) {
                                         kept.push_back(frame.sequence);
                                         return Status::ok;
                                       }};
  for (std::uint32_t i = 0; i < 2; ++i) {
    hal::Frame frame;
    ASSERT_EQ(camera.acquire(frame, {}), Status::ok);
    EXPECT_EQ(frame.sequence, i);
    EXPECT_EQ(inner.lent, 1);
    camera.release(frame);
  }
  EXPECT_EQ(kept, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(inner.lent, 0);
}

TEST(KeepingCamera, GivesAFrameBackThatCannotBeKeptAndLeavesTheCallersUntouched) {
  for (const bool throws : {false, true}) {
    OnePixelCamera inner;
    KeepingCamera<OnePixelCamera> camera{inner, [&](const hal::Frame&, std::string& problem) {
                                           if (throws) throw std::runtime_error("disk full");
                                           problem = "disk full";
                                           return Status::io_error;
                                         }};
    hal::Frame untouched;
    untouched.sequence = 42;
    EXPECT_EQ(camera.acquire(untouched, {}), Status::io_error);
    EXPECT_EQ(untouched.sequence, 42u);
    EXPECT_EQ(untouched.pixels.data, nullptr);
    EXPECT_EQ(camera.problem(), "disk full");
    EXPECT_EQ(inner.lent, 0);
  }
}

TEST(KeepingCamera, KeepsNothingWhereNobodyWants) {
  OnePixelCamera inner;
  KeepingCamera<OnePixelCamera> camera{inner, {}};
  hal::Frame frame;
  EXPECT_EQ(camera.acquire(frame, {}), Status::ok);
}

}  // namespace
}  // namespace articam::sim
