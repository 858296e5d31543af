#pragma once
/// @file  Whether bytes are text.

#include <cstddef>
#include <cstdint>
#include <span>

namespace articam::wire {

/// UTF-8 in its shortest form, without halves of surrogate pairs, up to U+10FFFF.
/// Source  RFC 3629, section 4.
constexpr bool is_utf8(std::span<const std::uint8_t> bytes) noexcept {
  while (!bytes.empty()) {
    const std::uint8_t lead = bytes.front();
    const std::size_t size = lead < 0x80   ? 1
                             : lead < 0xc2 ? 0
                             : lead < 0xe0 ? 2
                             : lead < 0xf0 ? 3
                             : lead < 0xf5 ? 4
                                           : 0;
    if (size == 0 || size > bytes.size()) return false;
    for (const std::uint8_t next : bytes.subspan(1, size - 1)) {
      if ((next & 0xc0) != 0x80) return false;
    }
    if (lead == 0xe0 && bytes[1] < 0xa0) return false;  // would fit into two
    if (lead == 0xed && bytes[1] > 0x9f) return false;  // a surrogate
    if (lead == 0xf0 && bytes[1] < 0x90) return false;  // would fit into three
    if (lead == 0xf4 && bytes[1] > 0x8f) return false;  // beyond U+10FFFF
    bytes = bytes.subspan(size);
  }
  return true;
}

}  // namespace articam::wire
