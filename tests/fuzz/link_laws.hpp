#pragma once
/// @file  What must hold at the receiving end for every input whatever.

#include <array>
#include <cstdint>
#include <string>

#include "hal/receiver/intake.hpp"
#include "hal/wire/fault.hpp"
#include "tests/fuzz/mutation.hpp"
#include "tools/listen/decode.hpp"

namespace articam::fuzz {

struct Tally {
  std::uint64_t inputs{}, accepted{}, frames{};
  std::array<std::uint64_t, wire::kNumFaults> faults{};
};

/// Feeds mutated packets, message bodies and COBS streams to the decoders, each from a buffer of exactly its size, so
/// that the address sanitizer sees every read beyond it. Laws:
///   a damaged packet is refused, also when its checksum was made right again over a damaged header;
///   what is accepted passes every check, and the protobuf library reads the same message from it, to the last bit;
///   the decoder of articam-listen takes what the controller's reader takes, and refuses the rest for the same reason;
///   a sound frame after any stream and a delimiter is heard;
///   a refused packet leaves the intake as it was, but for its counters.
class LinkLaws {
 public:
  explicit LinkLaws(std::uint64_t seed) : random_{seed} {}

  /// One input. Empty, or which law it broke.
  std::string try_one();

  const Tally& tally() const { return tally_; }

 private:
  Bytes valid_payload();
  Bytes mutated_payload();
  std::string damaged_packet();
  std::string resealed_packet();
  std::string stream();
  std::string judge(const Bytes& payload);

  test::Random random_;
  Tally tally_;
  receiver::Intake intake_;
  listen::Decoder decoder_;
};

}  // namespace articam::fuzz
