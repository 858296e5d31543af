#include "hal/replay/pgm.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace articam::hal {
namespace {

class Pgm : public testing::Test {
 protected:
  Pgm()
      : folder_{std::filesystem::path{testing::TempDir()} / ("articam_pgm_" + std::to_string(std::random_device{}()))} {
    std::filesystem::create_directories(folder_);
  }
  ~Pgm() override { std::filesystem::remove_all(folder_); }

  Status read(const std::string& bytes) {
    std::ofstream(folder_ / "in.pgm", std::ios::binary) << bytes;
    return read_pgm(folder_ / "in.pgm", image_, why_);
  }

  std::filesystem::path folder_;
  GreyImage image_{1, 1, {42}};
  std::string why_;
};

TEST_F(Pgm, ReadsWhatItWroteWhateverTheStride) {
  const std::vector<std::uint8_t> pixels{1, 2, 3, 0, 4, 5, 255, 0};
  ASSERT_EQ(write_pgm(folder_ / "out.pgm", {pixels.data(), 3, 2, 4}, why_), Status::ok) << why_;
  ASSERT_EQ(read_pgm(folder_ / "out.pgm", image_, why_), Status::ok) << why_;
  EXPECT_EQ(image_.width_px, 3);
  EXPECT_EQ(image_.height_px, 2);
  EXPECT_EQ(image_.pixels, (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 255}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator{folder_}, {}), 1) << "no temporary file is left";
}

TEST_F(Pgm, ReadsCommentsAndScalesTheMaximumTo255) {
  ASSERT_EQ(read("P5 # a comment\n# another 7 7\n2\t1 #end\n3\n" + std::string("\x00\x03", 2)), Status::ok) << why_;
  EXPECT_EQ(image_.pixels, (std::vector<std::uint8_t>{0, 255}));
}

TEST_F(Pgm, RefusesWhatIsNotAnEightBitImageOfItsSizeAndSaysWhy) {
  const std::vector<std::string> refused{"",
                                         "P",
                                         "P2\n1 1\n255\n0",
                                         "P5",
                                         "P5\n1",
                                         "P5\n1 1",
                                         "P5\n1 1\n255",
                                         "P5\n0 1\n255\n0",
                                         "P5\n-1 1\n255\n0",
                                         "P5\nx 1\n255\n0",
                                         "P5\n1 1\n0\n0",
                                         "P5\n1 1\n256\n00",
                                         "P5\n2 2\n255\n000",
                                         "P5\n1281 1\n255\n0",
                                         "P5\n99999999999 1\n255\n0",
                                         "P5\n1 1\n255#\n",
                                         "P5\n1 1\n100\n\x65",
                                         "P5 # without an end"};
  for (const std::string& bytes : refused) {
    why_.clear();
    EXPECT_EQ(read(bytes), Status::bad_argument) << bytes;
    EXPECT_FALSE(why_.empty()) << bytes;
    EXPECT_EQ(image_.pixels, std::vector<std::uint8_t>{42}) << "the output is unchanged";
  }
}

TEST_F(Pgm, SaysWhyAFileCannotBeReadOrWritten) {
  EXPECT_EQ(read_pgm(folder_ / "absent.pgm", image_, why_), Status::io_error);
  EXPECT_NE(why_.find("No such file or directory"), std::string::npos) << why_;
  EXPECT_NE(why_.find("absent"), std::string::npos) << why_;
  EXPECT_EQ(read_pgm(folder_, image_, why_), Status::io_error);
  EXPECT_EQ(write_pgm(folder_ / "absent" / "out.pgm", image_.view(), why_), Status::io_error);
  EXPECT_NE(why_.find("No such file or directory"), std::string::npos) << why_;
  EXPECT_NE(why_.find("absent"), std::string::npos) << why_;
  EXPECT_EQ(write_pgm(folder_, image_.view(), why_), Status::io_error);
  EXPECT_NE(why_.find("is a folder"), std::string::npos) << why_;
  EXPECT_EQ(write_pgm(folder_ / "out.pgm", {}, why_), Status::bad_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder_)) << "nothing half-written is left";
}

TEST_F(Pgm, SurvivesRandomBytes) {
  constexpr unsigned kSeed = 9;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  const std::string alphabet = "P5 \n#0123456789\t\xff";
  for (int run = 0; run < 2000; ++run) {
    std::string bytes = "P5";
    for (auto n = random() % 24; n > 0; --n) bytes += alphabet[random() % alphabet.size()];
    (void)read(bytes);
  }
}

}  // namespace
}  // namespace articam::hal
