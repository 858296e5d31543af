#include "hal/app/board/board_options.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace articam {
namespace {

using app::BoardOptions;

std::variant<BoardOptions, int> read(std::vector<const char*> words) {
  words.insert(words.begin(), "board");
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  auto result = app::read_board_options({"board", "Drawer", "Front", "1.2"}, static_cast<int>(words.size()),
                                        const_cast<char**>(words.data()));
  (void)testing::internal::GetCapturedStderr();
  (void)testing::internal::GetCapturedStdout();
  return result;
}
BoardOptions options(const std::vector<const char*>& words) {
  const auto result = read(words);
  EXPECT_TRUE(std::holds_alternative<BoardOptions>(result));
  return std::holds_alternative<BoardOptions>(result) ? std::get<BoardOptions>(result) : BoardOptions{};
}
int exit_code(const std::vector<const char*>& words) {
  const auto result = read(words);
  return std::holds_alternative<int>(result) ? std::get<int>(result) : -1;
}

TEST(BoardOptions, TakeTheFirstCameraOfLibcameraAndAMulticastGroupWhereNothingIsSaid) {
  const BoardOptions none = options({});
  EXPECT_EQ(none.source, BoardOptions::Source::libcamera);
  EXPECT_EQ(none.device, "");
  EXPECT_EQ(none.link, wire::kDefaultAddress);
  EXPECT_EQ(none.rate_hz, 30);
  EXPECT_FALSE(none.exposure_us || none.gain || none.cpu);
}

TEST(BoardOptions, KnowTheThreeKindsOfCamera) {
  EXPECT_EQ(options({"--camera", "libcamera:/base/i2c@1:x"}).device, "/base/i2c@1:x");
  const BoardOptions v4l2 = options({"--camera", "v4l2:/dev/video2"});
  EXPECT_EQ(v4l2.source, BoardOptions::Source::v4l2);
  EXPECT_EQ(v4l2.device, "/dev/video2");
  const BoardOptions replay = options({"--camera=replay:some/frames"});
  EXPECT_EQ(replay.source, BoardOptions::Source::replay);
  EXPECT_EQ(replay.device, "some/frames");
}

TEST(BoardOptions, RefuseWhatTheyDoNotKnowAsWrongUsage) {
  for (const char* const word :
       {"--camera=usb", "--camera=v4l2", "--camera=replay:", "--rate=0", "--priority=100", "--cpu=-1", "--gain=-1",
        "--stamp=noon", "--link=carrier-pigeon://roof", "--frames=many", "--frequency=30", "--key=k", "--counter=c",
        "--record-frames=f", "--record-mb=0", "stray"}) {
    EXPECT_EQ(exit_code({word}), 2) << word;
  }
}

TEST(BoardOptions, RefuseAKeyWhereNoPacketIsSent) {
  EXPECT_EQ(exit_code({"--link=stdout", "--key=k", "--counter=c"}), 2);
}

TEST(BoardOptions, TeachAndName) {
  EXPECT_EQ(exit_code({"--help"}), 0);
  EXPECT_EQ(exit_code({"--version"}), 0);
}

}  // namespace
}  // namespace articam
