#include "hal/authentication/counter_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "hal/wire/crc32.hpp"

namespace articam::hal {
namespace {

constexpr std::string_view kTitle = "articam-counter 1 ";
constexpr std::size_t kDigits = 20;

std::string text_of(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text = std::string{kTitle} + std::string(kDigits - digits.size(), '0') + digits;
  char sum[16];
  std::snprintf(sum, sizeof sum, " %08x\n",
                wire::crc32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
  return text + sum;
}

/// False unless it is, to the byte, what text_of() writes.
bool parse(std::string_view text, std::uint64_t& number) {
  if (text.size() != kTitle.size() + kDigits + 10) return false;
  const char* const digits = text.data() + kTitle.size();
  std::uint64_t x = 0;
  if (std::from_chars(digits, digits + kDigits, x).ec != std::errc{} || text != text_of(x)) return false;
  number = x;
  return true;
}

/// A descriptor that closes itself; -1 is none.
class File {
 public:
  File(const std::string& path, int flags) noexcept : descriptor_{::open(path.c_str(), flags | O_CLOEXEC, 0600)} {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  explicit operator bool() const noexcept { return descriptor_ >= 0; }
  int get() const noexcept { return descriptor_; }

 private:
  int descriptor_;
};

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path{path}.parent_path().string();
  return folder.empty() ? "." : folder;
}

bool write_whole(const std::string& path, std::string_view text) noexcept {
  ::unlink(path.c_str());  // left by a crash, or put there by another: what it is or points to is not written to
  const File file{path, O_WRONLY | O_CREAT | O_EXCL};
  while (file && !text.empty()) {
    const ssize_t written = ::write(file.get(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return file && ::fsync(file.get()) == 0;
}

}  // namespace

Status CounterFile::fail(Status why, const std::string& what) {
  problem_ = path_ + ": " + what;
  if (why == Status::io_error) problem_ += std::string{": "} + std::strerror(errno);
  return why;
}

Status CounterFile::read(std::uint64_t& number) {
  const File file{path_, O_RDONLY | O_NONBLOCK};
  if (!file && errno == ENOENT) {
    number = 0;
    return Status::ok;
  }
  std::array<char, 64> text;  // one byte more than ours would show
  const ssize_t size = file ? ::read(file.get(), text.data(), text.size()) : -1;
  if (size < 0) return fail(Status::io_error, "cannot be read");
  if (parse({text.data(), static_cast<std::size_t>(size)}, number)) return Status::ok;
  return fail(
      Status::bad_argument,
      "is no whole counter file. Put it back from a copy; or make a new key, for the board and its controllers, "
      "and delete this file: with the old key, old packets would count as new ones");
}

Status CounterFile::write(std::uint64_t number) {
  const std::string part = path_ + ".part";
  if (!write_whole(part, text_of(number))) return fail(Status::io_error, "cannot be written");
  if (std::rename(part.c_str(), path_.c_str()) != 0) return fail(Status::io_error, "cannot be renamed into place");
  const File folder{folder_of(path_), O_RDONLY | O_DIRECTORY};
  return folder && ::fsync(folder.get()) == 0 ? Status::ok : fail(Status::io_error, "its folder cannot be synced");
}

Status CounterFile::add(std::uint64_t amount, std::uint64_t& before) {
  const File folder{folder_of(path_), O_RDONLY | O_DIRECTORY};
  if (!folder || ::flock(folder.get(), LOCK_EX) != 0) return fail(Status::io_error, "its folder cannot be locked");
  std::uint64_t number = 0;
  if (const Status status = read(number); status != Status::ok) return status;
  if (number > std::numeric_limits<std::uint64_t>::max() - amount) {
    return fail(Status::bad_argument, "all numbers are used up: make a new key and delete this file");
  }
  if (const Status status = write(number + amount); status != Status::ok) return status;
  before = number;
  return Status::ok;
}

}  // namespace articam::hal
