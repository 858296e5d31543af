#include "hal/authentication/key.hpp"

#include <fcntl.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace articam::hal {
namespace {

/// A credential of systemd lies in a folder that only the service can enter; its mode shows the mask of an ACL.
bool is_credential(const std::string& path) {
  const char* const folder = std::getenv("CREDENTIALS_DIRECTORY");
  return folder != nullptr && *folder != '\0' && std::filesystem::path{path}.parent_path() == folder;
}

/// Empty when the open file may hold a key.
std::string objection(int file, bool is_guarded) {
  struct stat found {};
  if (::fstat(file, &found) != 0 || !S_ISREG(found.st_mode)) return "is no plain file";
  if (!is_guarded && (found.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    return "can be read or written by others: chmod 600 it";
  if (found.st_size != 32) return "is not a key: head -c 32 /dev/urandom makes one";
  return {};
}

}  // namespace

Key::~Key() { ::sodium_memzero(bytes_.data(), bytes_.size()); }

Status Key::load(const std::string& path, std::string& problem) {
  if (::sodium_init() < 0) {
    problem = path + ": libsodium cannot be set up on this machine";
    return Status::io_error;
  }
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) {
    problem = path + ": cannot be opened: " + std::strerror(errno);
    return Status::io_error;
  }
  const std::string wrong = objection(file, is_credential(path));
  Key key;
  const bool whole = wrong.empty() && ::read(file, key.bytes_.data(), key.bytes_.size()) == 32;
  ::close(file);
  if (!whole) {
    problem = path + ": " + (wrong.empty() ? "cannot be read" : wrong);
    return Status::bad_argument;
  }
  *this = key;
  return Status::ok;
}

void Key::tag(std::span<const std::uint8_t> covered, wire::Tag out) const noexcept {
  // Cannot fail: sizes of tag and key are within the function's limits.
  ::crypto_generichash(out.data(), out.size(), covered.data(), covered.size(), bytes_.data(), bytes_.size());
}

bool Key::matches(std::span<const std::uint8_t> covered, wire::ConstTag tag) const noexcept {
  std::array<std::uint8_t, wire::kTagSize> right;
  this->tag(covered, right);
  return ::sodium_memcmp(right.data(), tag.data(), right.size()) == 0;
}

}  // namespace articam::hal
