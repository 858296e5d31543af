#pragma once
/// @file  Signs the packets of a board.

#include <cstdint>
#include <string>

#include "hal/authentication/counter_file.hpp"
#include "hal/authentication/key.hpp"

namespace articam::hal {

/// No counter is ever used twice with a key, whatever happens to the board: a whole block of them is reserved on the
/// disk before its first is used, and a start takes a new block. A block lasts for 34 years at 1000 packets a second,
/// so that the disk is touched at the start alone, never in the loop; there are blocks for 2^24 starts, one a minute
/// for 31 years.
class KeyedSigner final : public wire::Signer {
 public:
  static constexpr std::uint64_t kBlock = std::uint64_t{1} << 40;

  KeyedSigner(const Key& key, std::string counter_path, std::uint64_t block = kBlock)
      : key_{key}, file_{std::move(counter_path)}, block_{block} {}

  /// Reserves the block: before the first packet.
  /// Errors  io_error, bad_argument; problem() is then a sentence.
  Status open();
  const std::string& problem() const noexcept { return file_.problem(); }

  /// Errors  io_error when the block is used up: start anew.
  Result<std::uint64_t> next_counter() noexcept override;
  void sign(std::span<const std::uint8_t> covered, wire::Tag tag) noexcept override { key_.tag(covered, tag); }

 private:
  Key key_;
  CounterFile file_;
  std::uint64_t block_;
  std::uint64_t next_{}, end_{};  ///< of the reserved block
};

}  // namespace articam::hal
