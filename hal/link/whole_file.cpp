#include "hal/link/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace articam::hal {
namespace {

/// Whether a rename onto that name would replace something that is no plain file, a symbolic link included.
bool is_special(const std::string& path) noexcept {
  struct stat found {};
  return ::lstat(path.c_str(), &found) == 0 && !S_ISREG(found.st_mode);
}

}  // namespace

WholeFile::~WholeFile() { abandon(); }

Status WholeFile::open(const std::string& path) noexcept {
  abandon();
  path_ = path;
  if (is_special(path)) return fail("is a folder, a link or a device: only a plain file is replaced", 0);
  constexpr int kNames = 100;  // more than that were left by crashes, or are being written now
  for (int i = 0; i < kNames; ++i) {
    part_ = path + ".part" + std::to_string(i);
    descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) return Status::ok;
    if (errno != EEXIST) break;
  }
  part_.clear();  // another's
  return fail("cannot be created", errno);
}

Status WholeFile::write(std::string_view text) noexcept {
  if (descriptor_ < 0) return Status::io_error;  // not open, or a failure that problem() tells
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return fail("cannot be written", errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return Status::ok;
}

Status WholeFile::close() noexcept {
  if (descriptor_ < 0) return Status::io_error;
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) return fail("cannot be written", errno);
  // Whatever close() returns, the descriptor is gone: a second one could close somebody else's file.
  if (::close(std::exchange(descriptor_, -1)) != 0) return fail("cannot be written", errno);
  if (std::rename(part_.c_str(), path_.c_str()) != 0) return fail("cannot be renamed into place", errno);
  part_.clear();
  return Status::ok;
}

Status WholeFile::fail(std::string_view what, int error) noexcept {
  problem_ = path_ + ": " + std::string(what) + (error == 0 ? "" : std::string(": ") + std::strerror(error));
  abandon();
  return Status::io_error;
}

void WholeFile::abandon() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (!part_.empty()) ::unlink(part_.c_str());
  part_.clear();
}

}  // namespace articam::hal
