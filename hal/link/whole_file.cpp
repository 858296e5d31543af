#include "hal/link/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace articam::hal {

WholeFile::~WholeFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(part_.c_str());
}

Status WholeFile::open(const std::string& path) noexcept {
  path_ = path;
  part_ = path + ".part";
  descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  return descriptor_ < 0 ? fail("cannot be created") : Status::ok;
}

Status WholeFile::write(std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return fail("cannot be written");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return Status::ok;
}

Status WholeFile::close() noexcept {
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) return fail("cannot be written");
  if (::close(descriptor_) != 0) return fail("cannot be written");
  descriptor_ = -1;
  return std::rename(part_.c_str(), path_.c_str()) == 0 ? Status::ok : fail("cannot be renamed into place");
}

Status WholeFile::fail(std::string_view what) noexcept {
  problem_ = path_ + ": " + std::string(what) + ": " + std::strerror(errno);
  return Status::io_error;
}

}  // namespace articam::hal
