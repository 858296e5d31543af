#pragma once
/// @file  What must hold at the receiving end for every input whatever.

#include <array>
#include <cstdint>
#include <string>

#include "hal/receiver/intake.hpp"
#include "hal/wire/fault.hpp"
#include "tests/fuzz/mutation.hpp"

namespace articam::fuzz {

struct Tally {
  std::uint64_t inputs{}, accepted{}, frames{};
  std::array<std::uint64_t, wire::kNumFaults> faults{};
};

/// Feeds mutated packets, message bodies and COBS streams to the decoders, each from a buffer of exactly its size, so
/// that the address sanitizer sees every read beyond it. Laws:
///   a damaged packet is refused, also when its checksum was made right again over a damaged header;
///   what is accepted passes every check, and the protobuf library reads the same message from it, to the last bit;
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
  std::string damaged_packet();
  std::string resealed_packet();
  std::string body();
  std::string stream();
  std::string judge(const Bytes& payload, wire::Fault fault, const wire::Message& message);

  test::Random random_;
  Tally tally_;
  receiver::Intake intake_;
};

}  // namespace articam::fuzz
