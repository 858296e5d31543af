#include "tools/listen/decode.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hal/wire/message_reader.hpp"
#include "tests/support/wire_messages.hpp"

namespace articam::listen {
namespace {

using wire::Fault;

TEST(Decoder, ReadsEveryNumberToTheLastBit) {
  test::Random random{31};
  Decoder decoder;
  wire::Message out;
  for (std::size_t trial = 0; trial < 100; ++trial) {
    const auto estimate = test::random_estimate(random, trial % (wire::kMaxJoints + 1));
    const auto model = test::random_model(random, trial % (wire::kMaxJoints + 1));
    ASSERT_EQ(decoder.decode(test::packet_of(estimate), out), Fault::none) << "seed 31, trial " << trial;
    EXPECT_EQ(test::by_protobuf(out), test::by_protobuf(estimate));
    ASSERT_EQ(decoder.decode(test::packet_of(model), out), Fault::none) << "seed 31, trial " << trial;
    EXPECT_EQ(test::by_protobuf(out), test::by_protobuf(model));
  }
}

// tests/fuzz holds this for a million payloads that are damaged in more ways.
TEST(Decoder, TakesWhatTheReceiversReaderTakesAndReadsTheSame) {
  test::Random random{32};
  Decoder decoder;
  int taken = 0, refused = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::string payload = test::by_protobuf(test::random_estimate(random, 1));
    const auto place = static_cast<std::size_t>(random.uniform(0, static_cast<double>(payload.size())));
    payload[place] = static_cast<char>(static_cast<int>(random.uniform(0, 256)));
    wire::Message ours, theirs;
    const Fault fault = wire::read_message(test::bytes_of(payload), theirs);
    ASSERT_EQ(decoder.decode_payload(test::bytes_of(payload), ours), fault) << "seed 32, trial " << trial;
    ++(fault == Fault::none ? taken : refused);
    if (fault != Fault::none) continue;
    ASSERT_EQ(test::by_protobuf(ours), test::by_protobuf(theirs)) << "seed 32, trial " << trial;
  }
  EXPECT_GT(taken, 1000) << "the comparison has met nothing";
  EXPECT_GT(refused, 1000) << "the changes were harmless";
}

TEST(Decoder, RefusesWhatProtobufAloneWouldTolerate) {
  Decoder decoder;
  wire::Message out;
  wire::Packet packet;
  packet.mutable_estimate()->set_schema(wire::kSchema);
  const std::string good = packet.SerializeAsString();
  EXPECT_EQ(decoder.decode_payload(test::bytes_of(good), out), Fault::none);
  EXPECT_EQ(decoder.decode_payload(test::bytes_of(good + good), out), Fault::malformed) << "it would merge the two";
  const std::string large = std::string("\x0a\x08\x08") + char{wire::kSchema} + "\x20" + "\xff\xff\xff\xff\x7f";
  ASSERT_TRUE(packet.ParseFromString(large)) << "it cuts a number of 35 bits";
  EXPECT_EQ(decoder.decode_payload(test::bytes_of(large), out), Fault::malformed);
}

TEST(Decoder, TellsWhyAPacketIsRefused) {
  test::Random random{33};
  Decoder decoder;
  wire::Message out;
  auto estimate = test::random_estimate(random);
  const auto good = test::packet_of(estimate);
  auto flipped = good;
  flipped[20] ^= 1;
  EXPECT_EQ(decoder.decode(flipped, out), Fault::wrong_checksum);
  EXPECT_EQ(decoder.decode(std::span{good}.first(10), out), Fault::wrong_length);
  EXPECT_EQ(decoder.decode(test::bytes_of("a guest"), out), Fault::foreign);
  EXPECT_EQ(decoder.decode({}, out), Fault::foreign);
  EXPECT_EQ(decoder.decode(test::sealed("\xff"), out), Fault::malformed);
  EXPECT_EQ(decoder.decode(test::sealed(std::string(1, '\x12') + '\0'), out), Fault::unknown_schema);  // empty Model
  estimate.joints.clear();
  EXPECT_EQ(decoder.decode(test::packet_of(estimate), out), Fault::inconsistent);
  estimate.schema = wire::kSchema + 1;
  EXPECT_EQ(decoder.decode(test::packet_of(estimate), out), Fault::unknown_schema);
}

TEST(Decoder, RefusesWordsThatItDoesNotKnowAndMoreJointsThanABoardSends) {
  Decoder decoder;
  wire::Message out;
  const auto verdict = [&](const auto& change) {
    wire::Packet packet;
    packet.mutable_estimate()->set_schema(wire::kSchema);
    change(*packet.mutable_estimate());
    const std::string payload = packet.SerializeAsString();
    return decoder.decode_payload(test::bytes_of(payload), out);
  };
  EXPECT_EQ(verdict([](wire::Estimate&) {}), Fault::none);
  EXPECT_EQ(verdict([](wire::Estimate& e) { e.set_status(static_cast<wire::Status>(99)); }), Fault::malformed);
  EXPECT_EQ(verdict([](wire::Estimate& e) { e.set_reason(static_cast<wire::Reason>(99)); }), Fault::malformed);
  EXPECT_EQ(verdict([](wire::Estimate& e) { e.add_observability(static_cast<wire::Observability>(9)); }),
            Fault::malformed);
  EXPECT_EQ(verdict([](wire::Estimate& e) {
              for (int i = 0; i < 17; ++i) e.add_joints(0);
            }),
            Fault::malformed);
}

}  // namespace
}  // namespace articam::listen
