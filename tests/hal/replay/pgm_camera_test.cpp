#include "hal/replay/pgm_camera.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/own_folder.hpp"

namespace articam {
namespace {

class PgmCamera : public testing::Test {
 protected:
  PgmCamera() {
    std::filesystem::create_directories(folder_);
    for (int i : {2, 0, 1}) {
      const std::uint8_t grey[]{static_cast<std::uint8_t>(i), 7};
      std::string why;
      EXPECT_EQ(hal::write_pgm(folder_ / ("frame_" + std::to_string(i) + ".pgm"), {grey, 2, 1, 2}, why), Status::ok)
          << why;
    }
    std::ofstream{folder_ / "notes.txt"} << "no frame";
  }
  ~PgmCamera() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_ = test::own_folder();
};

TEST_F(PgmCamera, PlaysTheFramesOfAFolderByNameAtItsRate) {
  hal::PgmCamera camera{hal::find_frames(folder_.string()), 50};
  ASSERT_EQ(camera.start(), Status::ok);
  for (std::uint32_t i = 0; i < 3; ++i) {
    hal::Frame frame;
    ASSERT_EQ(camera.acquire(frame, {}), Status::ok);
    EXPECT_EQ(frame.sequence, i);
    EXPECT_EQ(frame.t_exposure, from_seconds(0.02 * i));
    EXPECT_EQ(frame.pixels.row(0)[0], i);
    camera.release(frame);
  }
  hal::Frame untouched;
  EXPECT_EQ(camera.acquire(untouched, {}), Status::end_of_stream);
  EXPECT_EQ(untouched.pixels.data, nullptr);
}

TEST_F(PgmCamera, FindsFramesByPatternAndNothingWhereThereIsNothing) {
  EXPECT_EQ(hal::find_frames((folder_ / "frame_[12].pgm").string()).size(), 2u);
  EXPECT_EQ(hal::find_frames((folder_ / "frame_0.pgm").string()).size(), 1u);
  EXPECT_TRUE(hal::find_frames((folder_ / "none_*.pgm").string()).empty());
}

TEST_F(PgmCamera, TellsAFileThatIsNoFrameAndGoesOnWithTheNext) {
  std::ofstream{folder_ / "frame_0.pgm"} << "P5 2 1";
  hal::PgmCamera camera{hal::find_frames(folder_.string()), 50};
  hal::Frame frame;
  EXPECT_EQ(camera.acquire(frame, {}), Status::bad_argument);
  EXPECT_NE(camera.problem().find("frame_0.pgm"), std::string::npos);
  ASSERT_EQ(camera.acquire(frame, {}), Status::ok);
  EXPECT_EQ(frame.sequence, 1u);
}

}  // namespace
}  // namespace articam
