#include "hal/authentication/key.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "tests/support/own_folder.hpp"

namespace articam {
namespace {

namespace fs = std::filesystem;

class Key : public testing::Test {
 protected:
  Key() { fs::create_directories(folder_); }
  ~Key() override { fs::remove_all(folder_); }

  std::string file_of(const std::string& bytes, fs::perms mode = fs::perms::owner_read) const {
    const fs::path path = folder_ / "key";
    fs::remove(path);
    std::ofstream{path, std::ios::binary} << bytes;
    fs::permissions(path, mode);
    return path.string();
  }
  Status load(const std::string& path) { return key_.load(path, problem_); }
  std::vector<std::uint8_t> tag(const std::vector<std::uint8_t>& covered) const {
    std::vector<std::uint8_t> out(wire::kTagSize);
    key_.tag(covered, wire::Tag{out});
    return out;
  }

  const fs::path folder_ = test::own_folder();
  hal::Key key_;
  std::string problem_;
};

TEST_F(Key, IsExactly32BytesThatOnlyTheOwnerCanRead) {
  EXPECT_EQ(load(file_of(std::string(32, 'k'))), Status::ok);
  for (const std::size_t size : {0u, 31u, 33u, 64u}) {
    EXPECT_EQ(load(file_of(std::string(size, 'k'))), Status::bad_argument);
    EXPECT_NE(problem_.find("urandom"), std::string::npos) << problem_;
  }
  for (const auto others : {fs::perms::group_read, fs::perms::others_read, fs::perms::others_write}) {
    EXPECT_EQ(load(file_of(std::string(32, 'k'), fs::perms::owner_read | others)), Status::bad_argument);
    EXPECT_NE(problem_.find("chmod 600"), std::string::npos) << problem_;
  }
}

TEST_F(Key, MayShowAnyModeInTheFolderOfTheServicesCredentialsAndOnlyThere) {
  const auto path = [&] { return file_of(std::string(32, 'k'), fs::perms::owner_read | fs::perms::group_read); };
  ::setenv("CREDENTIALS_DIRECTORY", folder_.c_str(), 1);
  EXPECT_EQ(load(path()), Status::ok) << problem_;
  EXPECT_EQ(load(file_of("short")), Status::bad_argument);
  for (const char* const elsewhere : {"", "/", "/run/credentials"}) {
    ::setenv("CREDENTIALS_DIRECTORY", elsewhere, 1);
    EXPECT_EQ(load(path()), Status::bad_argument) << elsewhere;
  }
  ::unsetenv("CREDENTIALS_DIRECTORY");
}

TEST_F(Key, IsAPlainFileThatExists) {
  EXPECT_EQ(load((folder_ / "none").string()), Status::io_error);
  EXPECT_NE(problem_.find("No such file"), std::string::npos) << problem_;
  EXPECT_EQ(load(folder_.string()), Status::bad_argument);
}

TEST_F(Key, AFailedLoadLeavesTheKeyAsItWas) {
  ASSERT_EQ(load(file_of(std::string(32, 'k'))), Status::ok);
  const auto before = tag({1, 2, 3});
  EXPECT_NE(load(file_of("short")), Status::ok);
  EXPECT_EQ(tag({1, 2, 3}), before);
}

/// From Python's hashlib: blake2b(b"abc", digest_size=16, key=bytes(range(32))).
TEST_F(Key, MakesTheTagOfRfc7693) {
  std::string bytes(32, '\0');
  for (std::size_t i = 0; i < 32; ++i) bytes[i] = static_cast<char>(i);
  ASSERT_EQ(load(file_of(bytes)), Status::ok);
  EXPECT_EQ(tag({'a', 'b', 'c'}), (std::vector<std::uint8_t>{0x1a, 0x64, 0xbe, 0x47, 0xe4, 0x72, 0x9d, 0x95, 0x1c, 0x30,
                                                             0x2e, 0xe5, 0x43, 0xf9, 0x7c, 0xf3}));
}

TEST_F(Key, MatchesItsOwnTagAndNoneWithAFlippedBit) {
  ASSERT_EQ(load(file_of(std::string(32, 'k'))), Status::ok);
  const std::vector<std::uint8_t> covered{1, 2, 3};
  auto right = tag(covered);
  EXPECT_TRUE(key_.matches(covered, wire::ConstTag{right}));
  for (std::size_t bit = 0; bit < 8 * wire::kTagSize; ++bit) {
    auto wrong = right;
    wrong[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
    EXPECT_FALSE(key_.matches(covered, wire::ConstTag{wrong}));
  }
}

}  // namespace
}  // namespace articam
