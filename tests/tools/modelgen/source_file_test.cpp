#include "tools/modelgen/source_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace articam::modelgen {
namespace {

namespace fs = std::filesystem;

class SourceFileTest : public testing::Test {
 protected:
  SourceFileTest() { fs::create_directories(folder_); }
  ~SourceFileTest() override { fs::remove_all(folder_); }

  std::string write(const std::string& bytes) const {
    std::ofstream(folder_ / "file", std::ios::binary) << bytes;
    return (folder_ / "file").string();
  }
  static std::string why_refused(const std::string& path) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_source(path, diagnostics).has_value());
    return diagnostics.messages().empty() ? "" : diagnostics.messages().front().reason;
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(SourceFileTest, TakesUtf8TextUpToOneMebibyte) {
  Diagnostics diagnostics;
  EXPECT_TRUE(read_source(write("caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x9A\xAA"), diagnostics));
  EXPECT_TRUE(read_source(write(std::string(kMaxSourceBytes, 'a')), diagnostics));
  EXPECT_EQ(diagnostics.text(), "");
}

TEST_F(SourceFileTest, RefusesWhatCannotBeText) {
  EXPECT_EQ(why_refused(write(std::string(kMaxSourceBytes + 1, 'a'))), "is larger than 1 MiB");
  EXPECT_EQ(why_refused(write("")), "is empty");
  EXPECT_EQ(why_refused(folder_.string()), "is a folder, not a file");
  EXPECT_EQ(why_refused((folder_ / "absent").string()), "cannot be opened: No such file or directory");
  // A lone tail, an overlong slash, a surrogate, a code point beyond Unicode, a cut sequence, a zero byte.
  for (const char* bytes : {"\x80", "\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\x01"}) {
    EXPECT_EQ(why_refused(write(bytes)), "is not UTF-8 text; save it in that encoding");
  }
  EXPECT_NE(why_refused(write(std::string("a\0b", 3))), "");
}

TEST_F(SourceFileTest, HashesLikeFips180) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace articam::modelgen
