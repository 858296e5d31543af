#include "tools/modelgen/output_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/own_folder.hpp"

namespace articam::modelgen {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public testing::Test {
 protected:
  OutputFiles() { fs::create_directories(folder_); }
  ~OutputFiles() override { fs::remove_all(folder_); }

  std::string old(const char* name) const {
    std::ofstream(folder_ / name) << "old";
    return (folder_ / name).string();
  }
  static std::string read(const std::string& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  auto num_files() const { return std::distance(fs::directory_iterator(folder_), {}); }

  const fs::path folder_ = articam::test::own_folder();
};

TEST_F(OutputFiles, ReplaceOldOnes) {
  const std::string a = old("a"), b = (folder_ / "b").string();
  EXPECT_EQ(write_files({{a, "new"}, {b, "more"}}), "");
  EXPECT_EQ(read(a), "new");
  EXPECT_EQ(read(b), "more");
  EXPECT_EQ(num_files(), 2);
}

TEST_F(OutputFiles, AreAllOldWhenOneCannotBeWritten) {
  const std::string a = old("a"), b = (folder_ / "absent" / "b").string();
  EXPECT_EQ(write_files({{a, "new"}, {b, "new"}}), b + ": output: cannot be created: No such file or directory");
  EXPECT_EQ(write_files({{b, "new"}, {a, "new"}}), b + ": output: cannot be created: No such file or directory");
  EXPECT_EQ(read(a), "old");
  EXPECT_EQ(num_files(), 1) << "a temporary file stayed behind";
}

TEST_F(OutputFiles, ReplacePlainFilesOnly) {
  fs::create_directories(folder_ / "taken");
  fs::create_symlink(old("a"), folder_ / "link");
  for (const std::string& path :
       {(folder_ / "taken").string(), (folder_ / "link").string(), std::string("/dev/null")}) {
    EXPECT_EQ(write_files({{path, "new"}}),
              path + ": output: is a folder, a link or a device: only a plain file is replaced");
  }
  EXPECT_TRUE(fs::is_directory(folder_ / "taken"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(num_files(), 3) << "a temporary file stayed behind";
}

}  // namespace
}  // namespace articam::modelgen
