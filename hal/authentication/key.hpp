#pragma once
/// @file  The secret that a board and its controllers share.

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "core/status.hpp"
#include "hal/wire/authentication.hpp"

namespace articam::hal {

/// 32 random bytes; wiped from memory when it goes.
class Key {
 public:
  Key() noexcept = default;
  Key(const Key&) noexcept = default;
  Key& operator=(const Key&) noexcept = default;
  ~Key();

  /// A file of exactly 32 bytes that nobody but its owner may read or write. A file right in the folder that the
  /// variable CREDENTIALS_DIRECTORY names is guarded by that folder (systemd's LoadCredential): its mode is not asked.
  /// Errors  io_error; bad_argument. `problem` is then a sentence.
  Status load(const std::string& path, std::string& problem);

  /// Keyed BLAKE2b with 128 bits, by libsodium's crypto_generichash. No heap.
  /// Source  RFC 7693.
  void tag(std::span<const std::uint8_t> covered, wire::Tag out) const noexcept;
  /// Whether the tag is right; takes as long for every wrong one.
  bool matches(std::span<const std::uint8_t> covered, wire::ConstTag tag) const noexcept;

 private:
  std::array<std::uint8_t, 32> bytes_{};
};

}  // namespace articam::hal
