#include "tools/listen/record_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/own_folder.hpp"

namespace articam::listen {
namespace {

namespace fs = std::filesystem;

class RecordFileTest : public testing::Test {
 protected:
  RecordFileTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~RecordFileTest() override { fs::remove_all(folder_); }

  std::string content() const {
    std::ifstream stream{path_, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
  }

  const fs::path folder_ = test::own_folder();
  const std::string path_ = folder_ / "record";
};

TEST_F(RecordFileTest, HoldsEveryRecordBeforeItIsClosed) {
  RecordFile file;
  ASSERT_EQ(file.create(path_, false), "");
  EXPECT_EQ(file.append("one "), "");
  EXPECT_EQ(content(), "one ");
  EXPECT_EQ(file.append("two"), "");
  EXPECT_EQ(content(), "one two");
  EXPECT_EQ(file.size(), 7u);
  EXPECT_EQ(file.close(), "");
}

TEST_F(RecordFileTest, KeepsAnOlderRecordingUnlessToldOtherwise) {
  std::ofstream{path_} << "old";
  EXPECT_NE(RecordFile{}.create(path_, false), "");
  EXPECT_EQ(content(), "old");
  RecordFile file;
  EXPECT_EQ(file.create(path_, true), "");
  EXPECT_EQ(content(), "");
}

TEST_F(RecordFileTest, LeavesNoFileWithoutARecord) {
  EXPECT_EQ(RecordFile{}.create(path_, false), "");
  EXPECT_FALSE(fs::exists(path_));
  RecordFile file;
  EXPECT_EQ(file.create(path_, false), "");
  EXPECT_EQ(file.close(), "");
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(RecordFileTest, RefusesWhatIsNoPlainFile) {
  fs::create_symlink("elsewhere", folder_ / "link");
  for (const std::string& path : {folder_.string(), (folder_ / "link").string(), std::string{"/dev/null"}}) {
    EXPECT_NE(RecordFile{}.create(path, true), "") << path;
  }
  EXPECT_NE(RecordFile{}.create(folder_ / "absent/file", false), "");
}

TEST_F(RecordFileTest, TakesARecordBackThatDoesNotFitAndTellsFromThenOn) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  RecordFile file;
  ASSERT_EQ(file.create(path_, false), "");
  ASSERT_EQ(file.append("first"), "");
  const rlimit eight{8, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &eight), 0);
  const std::string problem = file.append("second");
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_NE(problem, "");
  EXPECT_EQ(content(), "first");
  EXPECT_EQ(file.append("third"), problem);
  EXPECT_EQ(file.close(), problem);
}

}  // namespace
}  // namespace articam::listen
