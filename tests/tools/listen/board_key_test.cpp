#include "tools/listen/board_key.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "hal/authentication/keyed_signer.hpp"
#include "tests/support/own_folder.hpp"
#include "tests/support/wire_messages.hpp"
#include "tools/listen/decode.hpp"

namespace articam::listen {
namespace {

namespace fs = std::filesystem;
using wire::Fault;

class BoardKey : public testing::Test {
 protected:
  BoardKey() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream{key_file_} << "32 bytes that nobody will guess.";
    fs::permissions(key_file_, fs::perms::owner_read);
  }
  ~BoardKey() override { fs::remove_all(folder_); }

  const fs::path folder_ = test::own_folder();
  const std::string key_file_ = folder_ / "board.key", state_file_ = folder_ / "state";
  std::string problem_;
};

TEST_F(BoardKey, LetsOnlyItsHoldersPacketsInAndEachOnce) {
  hal::Key key;
  ASSERT_EQ(key.load(key_file_, problem_), Status::ok) << problem_;
  hal::KeyedSigner signer{key, folder_ / "counter"};
  ASSERT_EQ(signer.open(), Status::ok) << signer.problem();
  test::Random random{34};
  const auto estimate = test::random_estimate(random);
  const auto packet = test::packet_of(estimate, &signer);
  wire::Message out;
  {
    const auto verifier = make_verifier(key_file_, state_file_, problem_);
    ASSERT_NE(verifier, nullptr) << problem_;
    Decoder decoder{verifier.get()};
    EXPECT_EQ(decoder.decode(packet, out), Fault::none);
    EXPECT_EQ(decoder.decode(packet, out), Fault::replayed);
    EXPECT_EQ(decoder.decode(test::packet_of(estimate), out), Fault::not_authentic);
  }
  const auto restarted = make_verifier(key_file_, state_file_, problem_);
  ASSERT_NE(restarted, nullptr) << problem_;
  EXPECT_EQ(Decoder{restarted.get()}.decode(packet, out), Fault::replayed) << "the state file remembers";
  EXPECT_EQ(Decoder{}.decode(packet, out), Fault::none) << "without a key everybody is heard";
}

TEST_F(BoardKey, TellsWhyAFileIsNone) {
  EXPECT_EQ(make_verifier(folder_ / "absent", "", problem_), nullptr);
  EXPECT_NE(problem_.find("absent"), std::string::npos) << problem_;
  std::ofstream{state_file_} << "something else";
  EXPECT_EQ(make_verifier(key_file_, state_file_, problem_), nullptr);
  EXPECT_NE(problem_.find("state"), std::string::npos) << problem_;
}

}  // namespace
}  // namespace articam::listen
