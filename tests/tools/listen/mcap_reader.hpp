#pragma once
/// @file  MCAP files and CDR messages as their specifications say, read without any code of the writer.
///
/// Source  mcap.dev/spec; OMG DDSI-RTPS 10.2 (CDR_LE: alignment from the end of the encapsulation)

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace articam::test {

/// Takes little-endian numbers and texts off the front; throws where there are not enough bytes.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_{bytes} {}

  std::string_view take(std::size_t size) {
    if (size > bytes_.size() - at_) throw std::out_of_range("a record is shorter than its fields");
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  template <class T>
  T number() {
    T x;
    std::memcpy(&x, take(sizeof x).data(), sizeof x);  // the tests run on little-endian machines
    return x;
  }
  std::string text() { return std::string{take(number<std::uint32_t>())}; }
  bool at_end() const { return at_ == bytes_.size(); }
  std::size_t at() const { return at_; }

 private:
  std::string_view bytes_;
  std::size_t at_{};
};

struct McapRecord {
  int opcode{};
  std::size_t start{};  ///< in the file
  std::string_view content;
};

/// All whole records after the magic; a torn one at the end is left out and `torn` says so.
struct McapFile {
  explicit McapFile(std::string_view bytes) {
    ByteReader reader{bytes};
    if (reader.take(8) != kMagic) throw std::runtime_error("no magic");
    while (!reader.at_end()) {
      const std::size_t start = reader.at();
      const std::string_view rest = bytes.substr(start);
      if (rest == kMagic) {
        closed = true;
        return;
      }
      if (rest.size() < 9) break;
      const int opcode = reader.number<std::uint8_t>();
      const auto length = reader.number<std::uint64_t>();
      if (length > rest.size() - 9) break;
      records.push_back({opcode, start, reader.take(length)});
    }
    torn = !reader.at_end();
  }

  static constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
  std::vector<McapRecord> records;
  bool closed{};  ///< ends with the magic
  bool torn{};
};

/// Plain CDR in little-endian order.
class CdrReader {
 public:
  explicit CdrReader(std::string_view message) : reader_{message.substr(4)} {
    if (message.substr(0, 4) != std::string_view{"\0\1\0\0", 4}) throw std::runtime_error("not CDR_LE");
  }
  template <class T>
  T number() {
    while (reader_.at() % sizeof(T) != 0) reader_.take(1);
    return reader_.number<T>();
  }
  std::string text() {
    const auto size = number<std::uint32_t>();
    const std::string_view bytes = reader_.take(size);
    if (size == 0 || bytes.back() != '\0') throw std::runtime_error("a string without its zero");
    return std::string{bytes.substr(0, size - 1)};
  }
  std::vector<double> doubles(std::size_t size) {
    std::vector<double> list;
    for (std::size_t i = 0; i < size; ++i) list.push_back(number<double>());
    return list;
  }
  std::vector<double> doubles() { return doubles(number<std::uint32_t>()); }
  std::vector<std::string> texts() {
    std::vector<std::string> list(number<std::uint32_t>());
    for (std::string& item : list) item = text();
    return list;
  }
  bool at_end() const { return reader_.at_end(); }

 private:
  ByteReader reader_;
};

}  // namespace articam::test
