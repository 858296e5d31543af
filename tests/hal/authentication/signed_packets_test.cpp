/// @file  Signer, packet and verifier together: who can be heard, and who not.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "hal/authentication/keyed_signer.hpp"
#include "hal/authentication/keyed_verifier.hpp"
#include "hal/receiver/intake.hpp"
#include "hal/wire/crc32.hpp"
#include "tests/support/heap_trap.hpp"
#include "tests/support/own_folder.hpp"
#include "tests/support/wire_messages.hpp"

namespace articam {
namespace {

namespace fs = std::filesystem;
using receiver::Intake;
using test::Bytes;
using wire::Fault;
using Taken = Intake::Taken;

class SignedPackets : public testing::Test {
 protected:
  SignedPackets() {
    fs::create_directories(folder_);
    key_ = key_of('k');
  }
  ~SignedPackets() override { fs::remove_all(folder_); }

  hal::Key key_of(char c) const {
    const fs::path path = folder_ / "key";
    fs::remove(path);
    std::ofstream{path, std::ios::binary} << std::string(32, c);
    fs::permissions(path, fs::perms::owner_read);
    hal::Key key;
    std::string problem;
    EXPECT_EQ(key.load(path.string(), problem), Status::ok) << problem;
    return key;
  }
  std::string counter() const { return (folder_ / "counter").string(); }
  std::string state() const { return (folder_ / "state").string(); }

  /// A packet of the board that this signer stands for.
  static Bytes packet(std::uint32_t number, wire::Signer* signer) {
    test::Random random{number};
    wire::EstimateMessage m = test::random_estimate(random);
    m.number = number, m.session = 1;
    return test::packet_of(m, signer);
  }
  static std::uint64_t count(const Intake& intake, Fault fault) {
    return intake.counters().faults[static_cast<std::size_t>(fault)];
  }

  const fs::path folder_ = test::own_folder();
  hal::Key key_;
};

/// What an attacker can do who knows everything but the key: any change, and the checksum made right again.
Bytes forged(Bytes packet, std::size_t bit) {
  packet[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
  const std::uint32_t crc = wire::crc32(std::span{packet}.first(packet.size() - 4));
  for (std::size_t i = 0; i < 4; ++i) packet[packet.size() - 4 + i] = static_cast<std::uint8_t>(crc >> 8 * i);
  return packet;
}

TEST_F(SignedPackets, AreTakenFromTheBoardAndFromNobodyElse) {
  hal::KeyedSigner board{key_, counter()}, stranger{key_of('s'), (folder_ / "other").string()};
  ASSERT_EQ(board.open(), Status::ok) << board.problem();
  ASSERT_EQ(stranger.open(), Status::ok);
  hal::KeyedVerifier verifier{key_};
  Intake intake{0, &verifier};
  EXPECT_EQ(intake.take(packet(1, &board), {}), Taken::estimate);
  EXPECT_EQ(intake.take(packet(2, &stranger), {}), Taken::nothing);
  EXPECT_EQ(intake.take(packet(2, nullptr), {}), Taken::nothing);
  EXPECT_EQ(count(intake, Fault::not_authentic), 2u);
  EXPECT_EQ(intake.take(packet(2, &board), {}), Taken::estimate);
}

TEST_F(SignedPackets, ForgedInAnySingleBitAreDroppedAndChangeNothing) {
  hal::KeyedSigner board{key_, counter()};
  ASSERT_EQ(board.open(), Status::ok);
  hal::KeyedVerifier verifier{key_};
  ASSERT_EQ(verifier.open(state()), Status::ok) << verifier.problem();
  Intake intake{0, &verifier};
  ASSERT_EQ(intake.take(packet(1, &board), {}), Taken::estimate);
  const std::string before = test::by_protobuf(intake.message());
  const Bytes next = packet(2, &board);
  for (std::size_t bit = 0; bit < 8 * (next.size() - 4); ++bit) {
    ASSERT_EQ(intake.take(forged(next, bit), {}), Taken::nothing) << "bit " << bit;
    ASSERT_EQ(test::by_protobuf(intake.message()), before);
  }
  EXPECT_GT(count(intake, Fault::not_authentic), 8 * (next.size() - 4 - wire::kHeaderSize) - 1);
  EXPECT_EQ(count(intake, Fault::replayed), 0u);
  EXPECT_EQ(intake.take(next, {}), Taken::estimate) << "the true one still counts";
  EXPECT_EQ(intake.counters().lost, 0u);
}

TEST_F(SignedPackets, PlayedBackAreDroppedAndChangeNothing) {
  hal::KeyedSigner board{key_, counter()};
  ASSERT_EQ(board.open(), Status::ok);
  hal::KeyedVerifier verifier{key_};
  Intake intake{0, &verifier};
  std::vector<Bytes> recorded;
  for (std::uint32_t k = 0; k < 50; ++k) {
    recorded.push_back(packet(k, &board));
    ASSERT_EQ(intake.take(recorded.back(), {}), Taken::estimate);
  }
  const std::string before = test::by_protobuf(intake.message());
  for (const Bytes& old : recorded) EXPECT_EQ(intake.take(old, {}), Taken::nothing);
  EXPECT_EQ(count(intake, Fault::replayed), 50u);
  EXPECT_EQ(intake.counters().duplicated, 0u) << "they do not even reach the numbers";
  EXPECT_EQ(test::by_protobuf(intake.message()), before);
}

TEST_F(SignedPackets, OfABoardThatStartedAgainAreTakenAndNoCounterComesTwice) {
  hal::KeyedVerifier verifier{key_};
  Intake intake{0, &verifier};
  std::uint64_t last = 0;
  for (std::uint32_t start = 0; start < 20; ++start) {
    hal::KeyedSigner board{key_, counter(), 10};
    ASSERT_EQ(board.open(), Status::ok);
    for (std::uint32_t k = 0; k < 10; ++k) {  // to the end of its block
      const Bytes bytes = packet(100 * start + k, &board);
      ASSERT_EQ(intake.take(bytes, {}), Taken::estimate);
      wire::PacketView view;
      ASSERT_EQ(wire::open_packet(bytes, view), Fault::none);
      ASSERT_TRUE(last == 0 || view.counter > last);
      last = view.counter;
    }
  }
}

TEST_F(SignedPackets, AreNotSentWhenNoCounterCanBePromised) {
  hal::KeyedSigner board{key_, counter(), 2};
  ASSERT_EQ(board.open(), Status::ok);
  EXPECT_FALSE(packet(1, &board).empty());
  EXPECT_FALSE(packet(2, &board).empty());
  EXPECT_TRUE(packet(3, &board).empty());  // its block is used up, and only a start may go to the disk
  ASSERT_EQ(board.open(), Status::ok);
  EXPECT_FALSE(packet(3, &board).empty());
  std::ofstream{counter()} << "another file";
  EXPECT_EQ(board.open(), Status::bad_argument);
  EXPECT_NE(board.problem().find("no whole counter file"), std::string::npos) << board.problem();
  EXPECT_TRUE(packet(4, &board).empty());
}

TEST_F(SignedPackets, OfYesterdayAreRefusedByAControllerThatStartedAgain) {
  hal::KeyedSigner board{key_, counter()};
  ASSERT_EQ(board.open(), Status::ok);
  const Bytes yesterday = packet(1, &board);
  {
    hal::KeyedVerifier verifier{key_};
    ASSERT_EQ(verifier.open(state()), Status::ok);
    Intake intake{0, &verifier};
    ASSERT_EQ(intake.take(yesterday, {}), Taken::estimate);
  }
  hal::KeyedVerifier verifier{key_};
  ASSERT_EQ(verifier.open(state()), Status::ok);
  Intake intake{0, &verifier};
  EXPECT_EQ(intake.take(yesterday, {}), Taken::nothing);
  EXPECT_EQ(count(intake, Fault::replayed), 1u);
  EXPECT_EQ(intake.take(packet(2, &board), {}), Taken::estimate);
}

TEST_F(SignedPackets, AStateFileThatIsNotWholeIsRefusedAndLeftAlone) {
  std::ofstream{state()} << "torn";
  {
    hal::KeyedVerifier verifier{key_};
    EXPECT_EQ(verifier.open(state()), Status::bad_argument);
    EXPECT_NE(verifier.problem().find(state()), std::string::npos) << verifier.problem();
  }
  EXPECT_EQ(fs::file_size(state()), 4u);
}

TEST_F(SignedPackets, SigningAndVerifyingDoNotTouchTheHeap) {
  if (!test::HeapTrap::works()) GTEST_SKIP() << "the heap cannot be replaced here (sanitizers bring their own)";
  hal::KeyedSigner board{key_, counter()};
  ASSERT_EQ(board.open(), Status::ok);
  hal::KeyedVerifier verifier{key_};
  Intake intake{0, &verifier};
  Bytes buffer(wire::kMaxPacketSize);
  const test::HeapTrap trap;
  for (int k = 0; k < 100; ++k) {
    const auto size = wire::seal_packet(buffer, 600, &board);
    (void)intake.take(std::span{buffer}.first(size.value()), {});
  }
  EXPECT_EQ(trap.calls(), 0);
}

}  // namespace
}  // namespace articam
