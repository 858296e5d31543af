#include "hal/wire/packet.hpp"

#include <algorithm>
#include <array>

#include "hal/wire/byte_order.hpp"
#include "hal/wire/crc32.hpp"

namespace articam::wire {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic{'A', 'T', 'C', 'M'};
constexpr std::uint8_t kFormat = 1;
constexpr std::uint8_t kHasTag = 1;  // the only flag

std::size_t whole_size(std::size_t payload_size, bool has_tag) noexcept {
  return kHeaderSize + payload_size + (has_tag ? kTrailerSize : 0) + kChecksumSize;
}

}  // namespace

Result<std::size_t> seal_packet(std::span<std::uint8_t> buffer, std::size_t payload_size, Signer* signer) noexcept {
  if (payload_size == 0 || payload_size > kMaxPayloadSize) return Status::bad_argument;
  const std::size_t size = whole_size(payload_size, signer != nullptr);
  if (buffer.size() < size) return Status::bad_argument;
  std::ranges::copy(kMagic, buffer.begin());
  buffer[4] = kFormat;
  buffer[5] = signer != nullptr ? kHasTag : 0;
  store(static_cast<std::uint16_t>(payload_size), buffer.subspan<6, 2>());
  if (signer != nullptr) {
    const auto counter = signer->next_counter();
    if (!counter.ok()) return counter.status();
    const std::size_t end = kHeaderSize + payload_size;
    store(counter.value(), buffer.subspan(end).first<kCounterSize>());
    signer->sign(buffer.first(end + kCounterSize), buffer.subspan(end + kCounterSize).first<kTagSize>());
  }
  store(crc32(buffer.first(size - kChecksumSize)), buffer.subspan(size - kChecksumSize).first<kChecksumSize>());
  return size;
}

Fault open_packet(std::span<const std::uint8_t> bytes, PacketView& out) noexcept {
  const std::size_t told = std::min(bytes.size(), kMagic.size());
  if (told == 0 || !std::equal(kMagic.begin(), kMagic.begin() + told, bytes.begin())) return Fault::foreign;
  if (bytes.size() < kHeaderSize + kChecksumSize) return Fault::wrong_length;
  // The checksum first: a flipped bit of version or flags is a changed packet, not another format.
  const auto body = bytes.first(bytes.size() - kChecksumSize);
  if (crc32(body) != load<std::uint32_t>(bytes.last<kChecksumSize>())) return Fault::wrong_checksum;
  if (bytes[4] != kFormat || (bytes[5] & ~kHasTag) != 0) return Fault::unknown_format;
  const std::size_t payload_size = load<std::uint16_t>(bytes.subspan<6, 2>());
  const bool has_tag = (bytes[5] & kHasTag) != 0;
  if (payload_size == 0 || payload_size > kMaxPayloadSize || bytes.size() != whole_size(payload_size, has_tag)) {
    return Fault::wrong_length;
  }
  out = {};
  out.payload = bytes.subspan(kHeaderSize, payload_size);
  if (has_tag) {
    const std::size_t end = kHeaderSize + payload_size;
    out.has_tag = true;
    out.counter = load<std::uint64_t>(bytes.subspan(end).first<kCounterSize>());
    out.covered = bytes.first(end + kCounterSize);
    out.tag = bytes.subspan(end + kCounterSize, kTagSize);
  }
  return Fault::none;
}

Fault authenticate(const PacketView& packet, Verifier* verifier) noexcept {
  if (verifier == nullptr) return Fault::none;
  if (!packet.has_tag) return Fault::not_authentic;
  return verifier->admit(packet.covered, packet.counter, packet.tag.first<kTagSize>());
}

}  // namespace articam::wire
