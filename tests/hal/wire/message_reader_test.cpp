#include "hal/wire/message_reader.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/wire_messages.hpp"

namespace articam {
namespace {

using wire::Fault;
using wire::MessageKind;

/// One field by hand: the tag of (number, wire type) below 16, then what follows.
std::string field(int number, int type, const std::string& rest) {
  return std::string(1, static_cast<char>(number << 3 | type)) + rest;
}
std::string in_packet(int content, const std::string& body) {
  return field(content, 2, std::string(1, static_cast<char>(body.size())) + body);
}
const std::string kSchemaField = field(1, 0, std::string(1, char{wire::kSchema}));

Fault verdict(const std::string& payload, wire::Message& out) {
  // Exactly as large as it is: the address sanitizer sees a read beyond its end.
  const std::vector<std::uint8_t> exact(payload.begin(), payload.end());
  return wire::parse_message(exact, out);
}
Fault verdict(const std::string& payload) {
  wire::Message out;
  return verdict(payload, out);
}

TEST(MessageReader, ReadsWhatProtobufWritesToTheLastBit) {
  test::Random random{7};
  for (std::size_t trial = 0; trial < 500; ++trial) {
    const std::string estimate = test::by_protobuf(test::random_estimate(random, trial % (wire::kMaxJoints + 1)));
    const std::string model = test::by_protobuf(test::random_model(random, trial % (wire::kMaxJoints + 1)));
    wire::Message out;
    ASSERT_EQ(wire::read_message(test::bytes_of(estimate), out), Fault::none) << "seed 7, trial " << trial;
    EXPECT_EQ(out.kind, MessageKind::estimate);
    EXPECT_EQ(test::by_protobuf(out), estimate);
    ASSERT_EQ(wire::read_message(test::bytes_of(model), out), Fault::none) << "seed 7, trial " << trial;
    EXPECT_EQ(out.kind, MessageKind::model);
    EXPECT_EQ(test::by_protobuf(out), model);
  }
}

TEST(MessageReader, RefusesEveryTruncatedMessageOrReadsNoMoreThanIsThere) {
  test::Random random{8};
  const std::string whole = test::by_protobuf(test::random_estimate(random));
  for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_EQ(verdict(whole.substr(0, size)), Fault::malformed);
}

TEST(MessageReader, TakesListsThatAreNotPacked) {
  std::string body = kSchemaField;
  for (int i = 0; i < 3; ++i) body += field(12, 1, std::string("\0\0\0\0\0\0\xf0\x3f", 8)) + field(15, 0, "\x02");
  wire::Message out;
  ASSERT_EQ(verdict(in_packet(1, body), out), Fault::none);
  ASSERT_EQ(out.estimate.joints.size(), 3u);
  EXPECT_EQ(out.estimate.joints[2], 1.0);
  EXPECT_EQ(out.estimate.observability[2], tracker::Observability::observed);
}

TEST(MessageReader, SkipsFieldsThatItDoesNotKnow) {
  const std::string unknown = "\xf8\x01\x05" /* 31, varint */ "\xf2\x01\x02xy" /* 30, bytes */;
  wire::Message out;
  ASSERT_EQ(verdict(in_packet(1, kSchemaField + unknown + field(4, 0, "\x2a")) + unknown, out), Fault::none);
  EXPECT_EQ(out.estimate.number, 42u);
}

TEST(MessageReader, RefusesAnotherSchemaBeforeItsFieldsMislead) {
  EXPECT_EQ(verdict(in_packet(1, field(1, 0, std::string(1, char{wire::kSchema + 1})) + field(2, 0, "\x01"))),
            Fault::unknown_schema);
  EXPECT_EQ(verdict(in_packet(1, "")), Fault::unknown_schema);
}

TEST(MessageReader, RefusesWhatIsNoMessage) {
  EXPECT_EQ(verdict(""), Fault::malformed);
  EXPECT_EQ(verdict(in_packet(3, "")), Fault::malformed) << "neither content";
  EXPECT_EQ(verdict(in_packet(1, kSchemaField) + in_packet(2, kSchemaField)), Fault::malformed) << "both contents";
  const auto body = [](const std::string& bytes) { return verdict(in_packet(1, kSchemaField + bytes)); };
  EXPECT_EQ(body(std::string(1, '\0')), Fault::malformed) << "field 0";
  EXPECT_EQ(body(field(4, 1, "12345678")), Fault::malformed) << "another wire type";
  EXPECT_EQ(body(field(3, 3, "")), Fault::malformed) << "a group";
  EXPECT_EQ(body(field(4, 0, "\xff\xff\xff\xff\xff\x01")), Fault::malformed) << "more than 32 bits";
  EXPECT_EQ(body(field(4, 0, std::string(10, '\xff'))), Fault::malformed) << "a varint without end";
  EXPECT_EQ(body(field(8, 0, "\x06")), Fault::malformed) << "a status without name";
  EXPECT_EQ(body(field(9, 0, "\x13")), Fault::malformed) << "a reason without name";
  EXPECT_EQ(body(field(15, 2, "\x01\x03")), Fault::malformed) << "an observability without name";
  EXPECT_EQ(body(field(12, 2,
                       "\x07"
                       "1234567")),
            Fault::malformed)
      << "no whole number of doubles";
  EXPECT_EQ(body(field(12, 2,
                       "\x7f"
                       "1234567")),
            Fault::malformed)
      << "longer than the message";
  const std::string one_in_six_bytes("\x81\x80\x80\x80\x80\0", 6);
  EXPECT_EQ(body("\xf2\x01" + one_in_six_bytes + "a"), Fault::malformed) << "a size that is padded too far";
}

TEST(MessageReader, TakesNamesOfUtf8Only) {
  const auto named = [](const std::string& name) {
    return verdict(in_packet(2, kSchemaField + field(4, 2, std::string(1, static_cast<char>(name.size())) + name)));
  };
  EXPECT_EQ(named("t\xc3\xbcr"), Fault::none);
  EXPECT_EQ(named("t\xfcr"), Fault::malformed) << "Latin 1";
  EXPECT_EQ(named("t\xc3"), Fault::malformed) << "half a character";
}

TEST(MessageReader, RefusesMoreNumbersThanThereIsRoomFor) {
  wire::Packet packet;
  packet.mutable_estimate()->set_schema(wire::kSchema);
  for (std::size_t i = 0; i < wire::kMaxJoints; ++i) packet.mutable_estimate()->add_joints(1);
  EXPECT_EQ(verdict(packet.SerializeAsString()), Fault::none);
  packet.mutable_estimate()->add_joints(1);
  EXPECT_EQ(verdict(packet.SerializeAsString()), Fault::malformed);
  packet.mutable_model()->set_schema(wire::kSchema);
  packet.mutable_model()->set_name(std::string(wire::kMaxName, 'a'));
  EXPECT_EQ(verdict(packet.SerializeAsString()), Fault::none);
  packet.mutable_model()->set_name(std::string(wire::kMaxName + 1, 'a'));
  EXPECT_EQ(verdict(packet.SerializeAsString()), Fault::malformed);
}

}  // namespace
}  // namespace articam
