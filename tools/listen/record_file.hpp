#pragma once
/// @file  A file that grows by whole records, and keeps them whatever happens to the program.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace articam::listen {

/// Each record is one write: killed at any time, the program leaves all records before. A record that does not fit on
/// the disk is taken back whole. A file without any record is removed. (What the system itself had not yet written is
/// lost when power goes.)
class RecordFile {
 public:
  RecordFile() = default;
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;
  ~RecordFile();

  /// Refuses a file that exists, unless `overwrite` is said and it is a plain one: recordings are not lost by a slip.
  /// All three are empty, or a sentence with path and cause; after a failure every call repeats it.
  std::string create(const std::string& path, bool overwrite);
  std::string append(std::string_view record);
  std::string close();

  std::uint64_t size() const { return size_; }

 private:
  std::string fail(const std::string& what, int error);

  int descriptor_{-1};
  std::uint64_t size_{};
  std::string path_, problem_;
};

}  // namespace articam::listen
