#include "tools/listen/mcap_output.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "hal/wire/crc32.hpp"
#include "tests/support/own_folder.hpp"
#include "tests/tools/listen/heard_estimate.hpp"
#include "tests/tools/listen/mcap_reader.hpp"

namespace articam::listen {
namespace {

constexpr int kHeader = 1, kFooter = 2, kSchema = 3, kChannel = 4, kMessage = 5, kStatistics = 11, kSummaryOffset = 14,
              kDataEnd = 15;

std::string read_file(const std::string& path) {
  std::ifstream stream{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// Three estimates, one of them without numbers, one without a pose in {base}.
class McapOutputTest : public testing::Test {
 protected:
  McapOutputTest() {
    auto file = std::make_unique<RecordFile>();
    EXPECT_EQ(file->create(path_, true), "");
    McapOutput output{std::move(file)};
    test::Random random{22};
    for (int i = 0; i < 3; ++i) {
      test::MadeUp made_up{random};
      if (i == 1) test::make_invalid(made_up.estimate);
      if (i == 2) made_up.estimate.t_base_obj.clear();
      made_up.estimate.number = static_cast<std::uint32_t>(40 + i);
      EXPECT_EQ(output.take(made_up.heard()), "");
    }
    unfinished_ = read_file(path_);
    EXPECT_EQ(output.finish(), "");
    bytes_ = read_file(path_);
  }
  ~McapOutputTest() override { std::filesystem::remove(path_); }

  const std::string path_ = test::own_folder();
  std::string unfinished_, bytes_;
};

TEST_F(McapOutputTest, HasTheSectionsOfTheFormatInTheirOrder) {
  const test::McapFile file{bytes_};
  EXPECT_TRUE(file.closed);
  std::string opcodes;
  for (const auto& record : file.records) opcodes += static_cast<char>('A' + record.opcode);
  // B header; D schema, E channel of four topics; F messages; P data end; summary; L statistics; O offsets; C footer
  EXPECT_EQ(opcodes,
            "BDEDEDEDE"
            "FFFF"
            "F"
            "FFF"
            "P"
            "DDDD"
            "EEEE"
            "L"
            "OOO"
            "C");
  test::ByteReader header{file.records[0].content};
  EXPECT_EQ(header.text(), "ros2");
}

TEST_F(McapOutputTest, GivesEveryMessageATopicWhoseTypeIsKnown) {
  std::map<int, std::string> types, topics;
  std::map<std::string, int> messages;
  for (const auto& record : test::McapFile{bytes_}.records) {
    test::ByteReader reader{record.content};
    if (record.opcode == kSchema) {
      const auto id = reader.number<std::uint16_t>();
      EXPECT_NE(id, 0);
      types[id] = reader.text();
      EXPECT_EQ(reader.text(), "ros2msg");
      EXPECT_NE(reader.text(), "");
      EXPECT_TRUE(reader.at_end());
    } else if (record.opcode == kChannel) {
      const auto id = reader.number<std::uint16_t>();
      const std::string type = types.at(reader.number<std::uint16_t>());
      topics[id] = reader.text() + ' ' + type;
      EXPECT_EQ(reader.text(), "cdr");
      EXPECT_EQ(reader.number<std::uint32_t>(), 0u);
      EXPECT_TRUE(reader.at_end());
    } else if (record.opcode == kMessage) {
      ++messages[topics.at(reader.number<std::uint16_t>())];
      const auto sequence = reader.number<std::uint32_t>();
      EXPECT_TRUE(sequence >= 40 && sequence < 43);
      EXPECT_EQ(reader.number<std::uint64_t>(), 1'700'000'000'040'000'000u);
      EXPECT_EQ(reader.number<std::uint64_t>(), 1'700'000'000'030'000'000u);
      EXPECT_EQ(reader.take(4), (std::string_view{"\0\1\0\0", 4}));
    }
  }
  EXPECT_EQ(messages,
            (std::map<std::string, int>{{"/articam/estimate articam_msgs/msg/Estimate", 3},
                                        {"/joint_states sensor_msgs/msg/JointState", 2},
                                        {"/articam/pose geometry_msgs/msg/PoseWithCovarianceStamped", 2},
                                        {"/articam/pose_base geometry_msgs/msg/PoseWithCovarianceStamped", 1}}));
}

TEST_F(McapOutputTest, HasASummaryThatPointsAtItself) {
  const test::McapFile file{bytes_};
  test::ByteReader footer{file.records.back().content};
  ASSERT_EQ(file.records.back().opcode, kFooter);
  const auto summary_start = footer.number<std::uint64_t>(), offsets_start = footer.number<std::uint64_t>();
  const std::size_t crc_at = bytes_.size() - 8 - 4;
  const auto covered = std::string_view{bytes_}.substr(summary_start, crc_at - summary_start);
  EXPECT_EQ(footer.number<std::uint32_t>(), wire::crc32(test::bytes_of(std::string{covered})));
  EXPECT_TRUE(footer.at_end());
  bool any_offset = false;
  for (std::size_t i = 0; i < file.records.size(); ++i) {
    const auto& record = file.records[i];
    if (record.opcode == kDataEnd) {
      EXPECT_EQ(file.records[i + 1].start, summary_start);
    }
    if (record.opcode != kSummaryOffset) continue;
    EXPECT_TRUE(any_offset || record.start == offsets_start);
    any_offset = true;
    test::ByteReader reader{record.content};
    const auto opcode = reader.number<std::uint8_t>();
    const auto start = reader.number<std::uint64_t>(), length = reader.number<std::uint64_t>();
    for (const auto& other : file.records) {
      const bool in_group = other.start >= start && other.start < start + length;
      EXPECT_EQ(in_group, other.opcode == opcode && other.start >= summary_start) << int{opcode};
    }
  }
  EXPECT_TRUE(any_offset);
}

TEST_F(McapOutputTest, CountsItsMessages) {
  for (const auto& record : test::McapFile{bytes_}.records) {
    if (record.opcode != kStatistics) continue;
    test::ByteReader reader{record.content};
    EXPECT_EQ(reader.number<std::uint64_t>(), 8u);
    EXPECT_EQ(reader.number<std::uint16_t>(), 4u) << "schemas";
    EXPECT_EQ(reader.number<std::uint32_t>(), 4u) << "channels";
    for (int i = 0; i < 3; ++i) EXPECT_EQ(reader.number<std::uint32_t>(), 0u);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(reader.number<std::uint64_t>(), 1'700'000'000'040'000'000u);
    EXPECT_EQ(reader.number<std::uint32_t>(), 4 * (2u + 8u));
    for (const std::uint64_t count : {3u, 2u, 2u, 1u}) {
      reader.number<std::uint16_t>();
      EXPECT_EQ(reader.number<std::uint64_t>(), count);
    }
    EXPECT_TRUE(reader.at_end());
    return;
  }
  FAIL() << "no statistics";
}

TEST_F(McapOutputTest, IsReadableUpToItsLastRecordWhereverItIsCut) {
  const test::McapFile whole{unfinished_};
  EXPECT_FALSE(whole.closed);
  EXPECT_FALSE(whole.torn) << "each record is written before the next begins";
  for (std::size_t size = 8; size < unfinished_.size(); ++size) {
    const test::McapFile cut{std::string_view{unfinished_}.substr(0, size)};
    ASSERT_LE(cut.records.size(), whole.records.size());
    for (std::size_t i = 0; i < cut.records.size(); ++i) ASSERT_EQ(cut.records[i].content, whole.records[i].content);
  }
  ASSERT_EQ(whole.records[0].opcode, kHeader);
  EXPECT_EQ(whole.records.back().opcode, kMessage);
}

}  // namespace
}  // namespace articam::listen
