#pragma once
/// @file  One row of the image as bits, light or dark, sixty-four pixels a word.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/config.hpp"
#include "core/vision/threshold_map.hpp"

namespace articam::vision {

/// Binarises the rows of one row of tiles after the other.
class BinaryRow {
 public:
  static constexpr int kMaxWords = (kMaxImageWidth_px + 63) / 64;

  /// Of the rows to come.
  void set_thresholds(const std::uint8_t* tiles, int width_px) noexcept {
    width_px_ = width_px;
    num_words_ = (width_px + 63) / 64;
    for (int u = 0; u < num_words_ * 64; u += kTile_px) {
      const int i_tile = u < width_px ? u / kTile_px : (width_px - 1) / kTile_px;
      std::memset(&threshold_[static_cast<std::size_t>(u)], tiles[i_tile], kTile_px);
    }
  }

  /// Beyond the width the last pixel's colour goes on.
  void compute(const std::uint8_t* grey) noexcept {
    const int whole = width_px_ / 64;
    for (int i = 0; i < whole; ++i) words_[static_cast<std::size_t>(i)] = word_of(grey + i * 64, i);
    if (whole == num_words_) return;
    std::array<std::uint8_t, 64> last;
    for (int u = 0; u < 64; ++u) {
      const int at = whole * 64 + u;
      last[static_cast<std::size_t>(u)] = grey[at < width_px_ ? at : width_px_ - 1];
    }
    words_[static_cast<std::size_t>(whole)] = word_of(last.data(), whole);
  }

  int num_words() const noexcept { return num_words_; }
  std::uint64_t word(int i) const noexcept { return words_[static_cast<std::size_t>(i)]; }

 private:
  std::uint64_t word_of(const std::uint8_t* grey, int i_word) const noexcept {
    const std::uint8_t* threshold = &threshold_[static_cast<std::size_t>(i_word) * 64];
    constexpr std::uint8_t kAll = 255, kNone = 0;
    std::array<std::uint8_t, 64> light;  // of the pixel 8 i + k: bit i
    for (std::size_t u = 0; u < 64; ++u) light[u] = kBit[u] & (grey[u] >= threshold[u] ? kAll : kNone);
    std::uint64_t columns = 0;  // byte k, bit i
    for (std::size_t i = 0; i < 8; ++i) {
      std::uint64_t eight;
      std::memcpy(&eight, &light[i * 8], sizeof eight);
      columns |= eight;
    }
    return transposed(columns);
  }

  // Bit i of byte k to bit k of byte i, by swaps in blocks of 1, 2 and 4.
  static std::uint64_t transposed(std::uint64_t x) noexcept {
    static_assert(std::endian::native == std::endian::little, "byte i must have the weight 256^i");
    const auto swap = [&x](int distance, std::uint64_t lower) {
      const std::uint64_t differ = (x ^ x >> distance) & lower;
      x ^= differ ^ differ << distance;
    };
    swap(7, 0x00aa00aa00aa00aau);
    swap(14, 0x0000cccc0000ccccu);
    swap(28, 0x00000000f0f0f0f0u);
    return x;
  }

  static constexpr std::array<std::uint8_t, 64> kBit = [] {
    std::array<std::uint8_t, 64> bit{};
    for (std::size_t u = 0; u < 64; ++u) bit[u] = static_cast<std::uint8_t>(1u << u / 8);
    return bit;
  }();

  int width_px_{}, num_words_{};
  std::array<std::uint8_t, std::size_t{kMaxWords} * 64> threshold_{};
  std::array<std::uint64_t, kMaxWords> words_{};
};

}  // namespace articam::vision
