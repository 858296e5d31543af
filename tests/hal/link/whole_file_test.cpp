#include "hal/link/whole_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/own_folder.hpp"
#include "tests/support/small_files.hpp"

namespace articam {
namespace {

namespace fs = std::filesystem;

class WholeFile : public testing::Test {
 protected:
  WholeFile() { fs::create_directories(folder_); }
  ~WholeFile() override { fs::remove_all(folder_); }

  std::string text() const {
    std::stringstream all;
    all << std::ifstream{path_}.rdbuf();
    return all.str();
  }
  void expect_refused(const fs::path& path) const {
    hal::WholeFile file;
    EXPECT_EQ(file.open(path.string()), Status::io_error) << path;
    EXPECT_NE(file.problem().find("only a plain file is replaced"), std::string::npos) << file.problem();
  }

  const fs::path folder_ = test::own_folder();
  const std::string path_ = (folder_ / "file").string();
};

TEST_F(WholeFile, ReplacesThePlainFileOnlyWhenItIsClosed) {
  std::ofstream{path_} << "old";
  hal::WholeFile file;
  ASSERT_EQ(file.open(path_), Status::ok);
  ASSERT_EQ(file.write("new"), Status::ok);
  EXPECT_EQ(text(), "old");
  ASSERT_EQ(file.close(), Status::ok);
  EXPECT_EQ(text(), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(WholeFile, HasTheModeThatTheUserAllows) {
  const mode_t before = ::umask(027);
  hal::WholeFile file;
  EXPECT_EQ(file.open(path_), Status::ok);
  EXPECT_EQ(file.close(), Status::ok);
  ::umask(before);
  EXPECT_EQ(static_cast<int>(fs::status(path_).permissions()), 0640);
}

TEST_F(WholeFile, RefusesATargetThatIsNoPlainFileBeforeAnyWork) {
  std::ofstream{path_} << "old";
  fs::create_directories(folder_ / "folder");
  fs::create_symlink(path_, folder_ / "link");
  fs::create_symlink(folder_ / "nowhere", folder_ / "dangling");
  expect_refused(folder_ / "folder");
  expect_refused(folder_ / "link");
  expect_refused(folder_ / "dangling");
  expect_refused("/dev/null");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(text(), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 4) << "a temporary file stayed behind";
}

TEST_F(WholeFile, LeavesNothingBehindAWriteThatFailedAndKeepsItsReason) {
  hal::WholeFile file;
  ASSERT_EQ(file.open(path_), Status::ok);
  {
    const test::SmallFiles limit{8};
    EXPECT_EQ(file.write("more than eight bytes"), Status::io_error);
  }
  EXPECT_TRUE(fs::is_empty(folder_));
  EXPECT_EQ(file.write("more"), Status::io_error);
  EXPECT_EQ(file.close(), Status::io_error);
  EXPECT_NE(file.problem().find("cannot be written: File too large"), std::string::npos) << file.problem();
}

TEST_F(WholeFile, LeavesNothingBehindARenameThatFailed) {
  hal::WholeFile file;
  ASSERT_EQ(file.open(path_), Status::ok);
  fs::create_directories(path_);  // taken meanwhile
  EXPECT_EQ(file.close(), Status::io_error);
  EXPECT_NE(file.problem().find("cannot be renamed into place"), std::string::npos) << file.problem();
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(WholeFile, LetsTwoWriteTheSameTargetTheLastOneWins) {
  hal::WholeFile first, second;
  ASSERT_EQ(first.open(path_), Status::ok);
  ASSERT_EQ(second.open(path_), Status::ok);
  ASSERT_EQ(first.write("first"), Status::ok);
  ASSERT_EQ(second.write("second"), Status::ok);
  ASSERT_EQ(first.close(), Status::ok);
  ASSERT_EQ(second.close(), Status::ok);
  EXPECT_EQ(text(), "second");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

}  // namespace
}  // namespace articam
