#include "hal/authentication/counter_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/own_folder.hpp"
#include "tests/support/small_files.hpp"

namespace articam {
namespace {

namespace fs = std::filesystem;

class CounterFile : public testing::Test {
 protected:
  CounterFile() { fs::create_directories(folder_); }
  ~CounterFile() override { fs::remove_all(folder_); }

  std::string text() const {
    std::stringstream all;
    all << std::ifstream{path_}.rdbuf();
    return all.str();
  }
  void put(const std::string& path, const std::string& text) const { std::ofstream{path, std::ios::binary} << text; }
  std::uint64_t number() const {
    std::uint64_t out = 0;
    hal::CounterFile file{path_};
    EXPECT_EQ(file.read(out), Status::ok) << file.problem();
    return out;
  }

  const fs::path folder_ = test::own_folder();
  const std::string path_ = (folder_ / "counter").string();
};

TEST_F(CounterFile, BeginsAtZeroAndGivesBackWhatWasWritten) {
  EXPECT_EQ(number(), 0u);
  for (const std::uint64_t x : {std::uint64_t{1}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    ASSERT_EQ(hal::CounterFile{path_}.write(x), Status::ok);
    EXPECT_EQ(number(), x);
  }
}

TEST_F(CounterFile, AddsAndTellsWhatWasBefore) {
  hal::CounterFile file{path_};
  std::uint64_t before = 99;
  ASSERT_EQ(file.add(10, before), Status::ok);
  EXPECT_EQ(before, 0u);
  ASSERT_EQ(file.add(5, before), Status::ok);
  EXPECT_EQ(before, 10u);
  EXPECT_EQ(number(), 15u);
}

TEST_F(CounterFile, NeverGoesRoundItsEnd) {
  hal::CounterFile file{path_};
  ASSERT_EQ(file.write(~std::uint64_t{0} - 3), Status::ok);
  std::uint64_t before = 99;
  EXPECT_EQ(file.add(4, before), Status::bad_argument);
  EXPECT_EQ(before, 99u);
  EXPECT_EQ(file.add(3, before), Status::ok);
}

/// Power goes while the new file is written: it was cut after any byte, and had not been renamed.
TEST_F(CounterFile, APowerLossAtAnyByteLeavesTheOldNumber) {
  ASSERT_EQ(hal::CounterFile{path_}.write(2000), Status::ok);
  const std::string next = text();
  ASSERT_EQ(hal::CounterFile{path_}.write(1000), Status::ok);
  for (std::size_t size = 0; size <= next.size(); ++size) {
    put(path_ + ".part", next.substr(0, size));
    ASSERT_EQ(number(), 1000u) << size;
  }
  std::uint64_t before = 0;
  ASSERT_EQ(hal::CounterFile{path_}.add(1, before), Status::ok) << "what was left behind is no obstacle";
  EXPECT_EQ(before, 1000u);
  EXPECT_FALSE(fs::exists(path_ + ".part"));
}

TEST_F(CounterFile, WritesThroughNoLinkThatStandsInItsWay) {
  const std::string part = path_ + ".part", victim = (folder_ / "victim").string();
  put(victim, "untouched");
  for (const bool symbolic : {true, false}) {
    symbolic ? fs::create_symlink(victim, part) : fs::create_hard_link(victim, part);
    ASSERT_EQ(hal::CounterFile{path_}.write(5), Status::ok);
    EXPECT_EQ(number(), 5u);
    std::string all;
    std::getline(std::ifstream{victim}, all);
    EXPECT_EQ(all, "untouched");
  }
}

TEST_F(CounterFile, ADiskThatIsFullAtAnyByteLeavesTheOldNumberAndGivesNoNewOne) {
  ASSERT_EQ(hal::CounterFile{path_}.write(1000), Status::ok);
  const auto size = fs::file_size(path_);
  for (rlim_t bytes = 0; bytes < size; ++bytes) {
    hal::CounterFile file{path_};
    std::uint64_t before = 7;
    const test::SmallFiles full{bytes};
    ASSERT_EQ(file.add(1, before), Status::io_error) << bytes;
    ASSERT_EQ(before, 7u);
    ASSERT_NE(file.problem().find(path_), std::string::npos) << file.problem();
  }
  EXPECT_EQ(number(), 1000u);
}

TEST_F(CounterFile, AFileThatIsCutOrChangedAnywhereIsRefusedAndLeftAsItIs) {
  ASSERT_EQ(hal::CounterFile{path_}.write(123456), Status::ok);
  const std::string whole = text();
  const auto refuses = [&](const std::string& torn) {
    put(path_, torn);
    hal::CounterFile file{path_};
    std::uint64_t out = 7;
    EXPECT_EQ(file.add(1, out), Status::bad_argument) << torn;
    EXPECT_EQ(out, 7u);
    EXPECT_NE(file.problem().find("new key"), std::string::npos) << "it says what can be done";
    EXPECT_EQ(text(), torn);
  };
  for (std::size_t size = 0; size < whole.size(); ++size) refuses(whole.substr(0, size));
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string changed = whole;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ 1 << bit % 8);
    refuses(changed);
  }
  refuses(whole + "x");
  refuses("root:x:0:0:root:/root:/bin/bash\n");
}

TEST_F(CounterFile, SaysWhyAFolderThatIsNotThereWillNotDo) {
  hal::CounterFile file{(folder_ / "nowhere" / "counter").string()};
  std::uint64_t before = 0;
  EXPECT_EQ(file.add(1, before), Status::io_error);
  EXPECT_NE(file.problem().find("nowhere"), std::string::npos) << file.problem();
}

}  // namespace
}  // namespace articam
