#pragma once
/// @file  The seam behind which packets are authenticated. The wire itself needs no cryptography.

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/status.hpp"
#include "hal/wire/fault.hpp"

namespace articam::wire {

inline constexpr std::size_t kCounterSize = 8;
inline constexpr std::size_t kTagSize = 16;
using Tag = std::span<std::uint8_t, kTagSize>;
using ConstTag = std::span<const std::uint8_t, kTagSize>;

/// What the sender asks. Chosen at run time by an option of the program, so the seam is a virtual one.
class Signer {
 public:
  /// A number that this key has never had before, larger than all before it.
  /// Errors  io_error when none can be promised; then nothing is sent.
  virtual Result<std::uint64_t> next_counter() noexcept = 0;
  /// The tag over everything that comes before it in the packet, the counter included.
  virtual void sign(std::span<const std::uint8_t> covered, Tag tag) noexcept = 0;

 protected:
  ~Signer() = default;
};

/// What the receiver asks. `covered` ends with the counter.
class Verifier {
 public:
  /// none when the tag is right and the counter is new; only then does the verifier remember anything. Otherwise
  /// not_authentic or replayed.
  virtual Fault admit(std::span<const std::uint8_t> covered, std::uint64_t counter, ConstTag tag) noexcept = 0;

 protected:
  ~Verifier() = default;
};

}  // namespace articam::wire
