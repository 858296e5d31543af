#include "tools/listen/mcap_writer.hpp"

#include <algorithm>
#include <array>
#include <concepts>

#include "hal/wire/byte_order.hpp"
#include "hal/wire/crc32.hpp"

namespace articam::listen {
namespace {

constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  statistics = 0x0b,
  summary_offset = 0x0e,
  data_end = 0x0f,
};

template <std::unsigned_integral T>
void put(std::string& out, T x) {
  std::array<std::uint8_t, sizeof(T)> bytes;
  wire::store(x, std::span{bytes});
  for (const std::uint8_t byte : bytes) out += static_cast<char>(byte);
}

void put(std::string& out, std::string_view text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  out += text;
}

std::string record(Opcode opcode, std::string_view content) {
  std::string record;
  put(record, static_cast<std::uint8_t>(opcode));
  put(record, std::uint64_t{content.size()});
  record += content;
  return record;
}

std::string header() {
  std::string content;
  put(content, std::string_view{"ros2"});
  put(content, std::string_view{"articam-listen"});
  return std::string{kMagic}.append(record(Opcode::header, content));
}

std::string data_end() {
  std::string content;
  put(content, std::uint32_t{0});  // no CRC
  return record(Opcode::data_end, content);
}

std::string summary_offset(Opcode group, std::uint64_t start, std::uint64_t length) {
  std::string content;
  put(content, static_cast<std::uint8_t>(group));
  put(content, start);
  put(content, length);
  return record(Opcode::summary_offset, content);
}

/// The CRC covers the summary and the footer up to itself.
std::string with_footer(std::string summary, std::uint64_t summary_start, std::uint64_t offsets_start) {
  put(summary, static_cast<std::uint8_t>(Opcode::footer));
  put(summary, std::uint64_t{8 + 8 + 4});
  put(summary, summary_start);
  put(summary, offsets_start);
  put(summary, wire::crc32({reinterpret_cast<const std::uint8_t*>(summary.data()), summary.size()}));
  return summary.append(kMagic);
}

}  // namespace

McapWriter::McapWriter(std::unique_ptr<RecordFile> file) : file_{std::move(file)} {
  static_cast<void>(file_->append(header()));  // the next call tells of a failure
}

std::string McapWriter::add_topic(std::string_view topic, std::string_view type, std::string_view definition) {
  const auto id = static_cast<std::uint16_t>(topics_.size() + 1);  // of schema and channel; 0 means none
  std::string schema, channel;
  put(schema, id);
  put(schema, type);
  put(schema, std::string_view{"ros2msg"});
  put(schema, definition);
  put(channel, id);
  put(channel, id);
  put(channel, topic);
  put(channel, std::string_view{"cdr"});
  put(channel, std::uint32_t{0});  // no metadata
  topics_.push_back({record(Opcode::schema, schema), record(Opcode::channel, channel)});
  return file_->append(topics_.back().schema + topics_.back().channel);
}

std::string McapWriter::write(const Message& message) {
  const auto log_time_ns = static_cast<std::uint64_t>(message.log_time_ns);
  std::string content;
  put(content, static_cast<std::uint16_t>(message.channel + 1));
  put(content, message.sequence);
  put(content, log_time_ns);
  put(content, static_cast<std::uint64_t>(message.publish_time_ns));
  content.append(message.cdr.begin(), message.cdr.end());
  if (std::string problem = file_->append(record(Opcode::message, content)); !problem.empty()) return problem;
  first_ns_ = num_messages_ == 0 ? log_time_ns : std::min(first_ns_, log_time_ns);
  last_ns_ = std::max(last_ns_, log_time_ns);
  ++num_messages_;
  ++topics_[message.channel].num_messages;
  return {};
}

std::string McapWriter::statistics() const {
  std::string content, counts;
  put(content, num_messages_);
  put(content, static_cast<std::uint16_t>(topics_.size()));    // schemas
  put(content, static_cast<std::uint32_t>(topics_.size()));    // channels
  for (int i = 0; i < 3; ++i) put(content, std::uint32_t{0});  // attachments, metadata, chunks
  put(content, first_ns_);
  put(content, last_ns_);
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    put(counts, static_cast<std::uint16_t>(i + 1));
    put(counts, topics_[i].num_messages);
  }
  put(content, counts);
  return record(Opcode::statistics, content);
}

std::string McapWriter::finish() {
  std::string end = data_end();
  const std::uint64_t summary_start = file_->size() + end.size();
  std::string summary, offsets;
  const auto add_group = [&](Opcode opcode, const std::string& records) {
    if (!records.empty()) offsets += summary_offset(opcode, summary_start + summary.size(), records.size());
    summary += records;
  };
  std::string schemas, channels;
  for (const Topic& topic : topics_) schemas += topic.schema, channels += topic.channel;
  add_group(Opcode::schema, schemas);
  add_group(Opcode::channel, channels);
  add_group(Opcode::statistics, statistics());
  const std::uint64_t offsets_start = summary_start + summary.size();
  end += with_footer(summary + offsets, summary_start, offsets_start);
  std::string problem = file_->append(end);
  return problem.empty() ? file_->close() : problem;
}

}  // namespace articam::listen
