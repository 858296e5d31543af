#pragma once
/// @file  MCAP files without chunks and compression: as small as a writer can be, whole after every record.
///
/// Source  mcap.dev/spec

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/listen/record_file.hpp"

namespace articam::listen {

/// Profile "ros2": schemas are ROS 2 message definitions, messages are CDR. Every call is empty or says why it failed,
/// as RecordFile. Readers open a file without its end too (`mcap recover` completes it); the CRC of the data section is
/// left out, as the format allows: it would say nothing of such a file.
class McapWriter {
 public:
  /// Starts the file.
  explicit McapWriter(std::unique_ptr<RecordFile> file);

  /// A topic and the type of its messages; `channel` numbers the topics from 0 in the order of these calls.
  std::string add_topic(std::string_view topic, std::string_view type, std::string_view definition);

  struct Message {
    std::size_t channel{};
    std::uint32_t sequence{};
    std::int64_t log_time_ns{};
    std::int64_t publish_time_ns{};
    std::span<const std::uint8_t> cdr;
  };
  std::string write(const Message& message);

  /// Ends data, writes the summary (schemas, channels, statistics and where they are) and closes the file.
  std::string finish();

 private:
  struct Topic {
    std::string schema, channel;  ///< their records, again for the summary
    std::uint64_t num_messages{};
  };

  std::string statistics() const;

  std::unique_ptr<RecordFile> file_;
  std::vector<Topic> topics_;
  std::uint64_t first_ns_{}, last_ns_{};  ///< log times, smallest and largest
  std::uint64_t num_messages_{};
};

}  // namespace articam::listen
