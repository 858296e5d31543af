#include "tools/listen/record_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace articam::listen {

RecordFile::~RecordFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (size_ == 0) ::unlink(path_.c_str());
}

std::string RecordFile::create(const std::string& path, bool overwrite) {
  path_ = path;
  struct stat found {};
  const bool exists = ::lstat(path.c_str(), &found) == 0;
  if (exists && !S_ISREG(found.st_mode))
    return fail("is a folder, a link or a device: only a plain file is replaced", 0);
  if (exists && !overwrite) return fail("exists: name another file, or give --overwrite", 0);
  if (exists) ::unlink(path.c_str());  // whoever still reads the old one keeps it
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  return descriptor_ >= 0 ? std::string{} : fail("cannot be created", errno);
}

std::string RecordFile::append(std::string_view record) {
  std::string_view rest = record;
  while (!rest.empty() && problem_.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
    if (written > 0 || (written < 0 && errno == EINTR)) continue;
    const int error = errno;
    const bool whole = ::ftruncate(descriptor_, static_cast<off_t>(size_)) == 0;
    return fail(whole ? "cannot be written; it ends with the last whole record" : "cannot be written", error);
  }
  if (problem_.empty()) size_ += record.size();
  return problem_;
}

std::string RecordFile::close() {
  if (!problem_.empty()) return problem_;
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) return fail("cannot be written", errno);
  // Whatever close() returns, the descriptor is gone: a second one could close somebody else's file.
  if (::close(std::exchange(descriptor_, -1)) != 0) return fail("cannot be written", errno);
  if (size_ == 0) ::unlink(path_.c_str());
  return {};
}

std::string RecordFile::fail(const std::string& what, int error) {
  problem_ = path_ + ": " + what + (error == 0 ? "" : std::string(": ") + std::strerror(error));
  return problem_;
}

}  // namespace articam::listen
