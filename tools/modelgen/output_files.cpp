#include "tools/modelgen/output_files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <string_view>

namespace articam::modelgen {
namespace {

bool write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// A file beside its target. It goes with this object unless it took the target's place.
class Pending {
 public:
  explicit Pending(const std::string& target) : target_{target} {}
  Pending(const Pending&) = delete;
  Pending& operator=(const Pending&) = delete;
  ~Pending() {
    if (!beside_.empty()) ::unlink(beside_.c_str());
  }

  /// Empty, or why not.
  std::string write(std::string_view content) {
    // A rename would replace the device or the symbolic link itself, not what it leads to.
    struct stat target {};
    if (::lstat(target_.c_str(), &target) == 0 && !S_ISREG(target.st_mode)) {
      return "is a folder, a link or a device: only a plain file is replaced";
    }
    std::string name = target_ + ".XXXXXX";
    const int file = ::mkstemp(name.data());
    if (file < 0) return std::string("cannot be created: ") + std::strerror(errno);
    beside_ = name;
    const mode_t mask = ::umask(0);  // mkstemp gives 0600; a header is for everybody the user allows
    ::umask(mask);
    const bool written = ::fchmod(file, 0666 & ~mask) == 0 && write_all(file, content) && ::fsync(file) == 0;
    int error = written ? 0 : errno;
    if (::close(file) != 0 && error == 0) error = errno;
    return error == 0 ? "" : std::string("cannot be written: ") + std::strerror(error);
  }

  std::string take_place() {
    if (::rename(beside_.c_str(), target_.c_str()) != 0)
      return std::string("cannot be written: ") + std::strerror(errno);
    beside_.clear();
    return "";
  }

 private:
  std::string target_, beside_;
};

}  // namespace

std::string write_files(const std::vector<OutputFile>& files) {
  std::deque<Pending> pending;
  for (const OutputFile& file : files) {
    pending.emplace_back(file.path);
    if (const std::string why = pending.back().write(file.bytes); !why.empty()) return file.path + ": output: " + why;
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (const std::string why = pending[i].take_place(); !why.empty()) return files[i].path + ": output: " + why;
  }
  return "";
}

}  // namespace articam::modelgen
