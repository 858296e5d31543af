#include "hal/replay/loop_camera.hpp"

#include <gtest/gtest.h>

#include "hal/replay/pgm_camera.hpp"
#include "tests/support/own_folder.hpp"

namespace articam {
namespace {

using std::chrono::milliseconds;

class LoopCamera : public testing::Test {
 protected:
  LoopCamera() {
    std::filesystem::create_directories(folder_);
    for (std::uint8_t i = 0; i < 3; ++i) {
      const std::uint8_t grey[]{i, 7};
      std::string why;
      EXPECT_EQ(hal::write_pgm(folder_ / (std::to_string(i) + ".pgm"), {grey, 2, 1, 2}, why), Status::ok) << why;
    }
  }
  ~LoopCamera() override { std::filesystem::remove_all(folder_); }

  hal::LoopCamera::Options options() const {
    return {.files = hal::find_frames(folder_.string()), .rate_hz = 300, .width_px = 2, .height_px = 1};
  }
  std::filesystem::path folder_ = test::own_folder();
};

TEST_F(LoopCamera, PlaysTheFilesAgainAndAgainWithTheSpansOfAPgmCamera) {
  hal::LoopCamera camera{options()};
  const hal::PgmCamera plain{{}, 300};
  ASSERT_EQ(camera.start(), Status::ok) << camera.problem();
  Timestamp first;
  for (std::uint32_t k = 0; k < 8; ++k) {
    hal::Frame frame;
    ASSERT_EQ(camera.acquire(frame, milliseconds{1000}), Status::ok);
    if (k == 0) first = frame.t_exposure;
    EXPECT_EQ(frame.t_exposure.ns - first.ns, plain.t_exposure(k).ns);
    EXPECT_EQ(frame.sequence, k);
    EXPECT_EQ(frame.pixels.row(0)[0], k % 3);
    camera.release(frame);
  }
}

TEST_F(LoopCamera, NeverLendsAFrameOfTheFuture) {
  hal::LoopCamera camera{options()};
  ASSERT_EQ(camera.start(), Status::ok);
  for (int k = 0; k < 5; ++k) {
    hal::Frame frame;
    ASSERT_EQ(camera.acquire(frame, milliseconds{1000}), Status::ok);
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    EXPECT_LE(frame.t_exposure.ns, std::chrono::nanoseconds{now}.count());
  }
}

TEST_F(LoopCamera, TimesOutBeforeTheNextFrameIsDueAndThenGivesIt) {
  auto slow = options();
  slow.rate_hz = 2;
  hal::LoopCamera camera{slow};
  ASSERT_EQ(camera.start(), Status::ok);
  hal::Frame frame;
  ASSERT_EQ(camera.acquire(frame, milliseconds{1}), Status::ok);
  hal::Frame untouched;
  EXPECT_EQ(camera.acquire(untouched, milliseconds{1}), Status::timeout);
  EXPECT_EQ(untouched.pixels.data, nullptr);
  ASSERT_EQ(camera.acquire(frame, milliseconds{5000}), Status::ok);
  EXPECT_EQ(frame.sequence, 1u);
}

TEST_F(LoopCamera, BeginsAnewWhenStartedAgain) {
  hal::LoopCamera camera{options()};
  for (int run = 0; run < 2; ++run) {
    ASSERT_EQ(camera.start(), Status::ok);
    hal::Frame frame;
    for (std::uint32_t k = 0; k < 4; ++k) {
      ASSERT_EQ(camera.acquire(frame, milliseconds{1000}), Status::ok);
      EXPECT_EQ(frame.sequence, k);
    }
    camera.stop();
  }
}

TEST_F(LoopCamera, RefusesFramesOfAnotherSizeAndAnEmptyFolderWithAWord) {
  auto other = options();
  other.height_px = 2;
  hal::LoopCamera wrong{other};
  EXPECT_EQ(wrong.start(), Status::bad_argument);
  EXPECT_NE(wrong.problem().find("0.pgm: is 2 x 1 pixels, but the camera file says 2 x 2"), std::string::npos)
      << wrong.problem();
  hal::LoopCamera none{{.files = {}, .width_px = 2, .height_px = 1}};
  EXPECT_EQ(none.start(), Status::no_device);
  EXPECT_FALSE(none.problem().empty());
  hal::Frame frame;
  EXPECT_EQ(none.acquire(frame, milliseconds{1}), Status::no_device);
}

}  // namespace
}  // namespace articam
