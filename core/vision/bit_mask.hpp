#pragma once
/// @file  One bit for each pixel, light or dark, and the scans along a row that regions are traced with.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/config.hpp"
#include "core/vision/image_view.hpp"
#include "core/vision/threshold_map.hpp"

namespace articam::vision {

enum class Colour : std::uint8_t { dark, light };

/// One row of a mask, seen so that the pixels of one colour are set. Columns 0 .. 64 * words - 1 may be read.
struct MaskRow {
  const std::uint64_t* words{};
  std::uint64_t flip{};
  int num_words{};

  std::uint64_t word(int i) const noexcept { return words[i] ^ flip; }
  bool at(int u) const noexcept { return (word(u >> 6) >> (u & 63) & 1) != 0; }

  /// First column at or after u that is set; the row's length where there is none.
  int next_set(int u) const noexcept { return next(u, 0); }
  /// First column at or after u that is clear; the row's length where there is none.
  int next_clear(int u) const noexcept { return next(u, ~std::uint64_t{0}); }
  /// Last column at or before u that is set, or clear; -1 where there is none.
  int last_set(int u) const noexcept { return last(u, 0); }
  int last_clear(int u) const noexcept { return last(u, ~std::uint64_t{0}); }
  /// Number of set pixels in columns a .. b, both included.
  int count(int a, int b) const noexcept;

 private:
  int next(int u, std::uint64_t invert) const noexcept {
    int i = u >> 6;
    if (i >= num_words) return num_words * 64;
    std::uint64_t bits = (word(i) ^ invert) & ~std::uint64_t{0} << (u & 63);
    while (bits == 0) {
      if (++i == num_words) return num_words * 64;
      bits = word(i) ^ invert;
    }
    return i * 64 + std::countr_zero(bits);
  }
  int last(int u, std::uint64_t invert) const noexcept {
    if (u < 0) return -1;
    int i = u >> 6;
    std::uint64_t bits = (word(i) ^ invert) & ~std::uint64_t{0} >> (63 - (u & 63));
    while (bits == 0) {
      if (--i < 0) return -1;
      bits = word(i) ^ invert;
    }
    return i * 64 + 63 - std::countl_zero(bits);
  }
};

/// The binary image. Bits beyond the width are dark; nothing that touches the border is a mark.
class BitMask {
 public:
  void binarise(const ImageView& image, const ThresholdMap& thresholds) noexcept;

  int width_px() const noexcept { return width_px_; }
  int height_px() const noexcept { return height_px_; }
  MaskRow row(int v, Colour colour) const noexcept {
    return {&words_[static_cast<std::size_t>(v * words_per_row_)], colour == Colour::light ? 0 : ~std::uint64_t{0},
            words_per_row_};
  }

 private:
  static constexpr int kMaxWordsPerRow = (kMaxImageWidth_px + 63) / 64;

  int width_px_{}, height_px_{}, words_per_row_{};
  std::array<std::uint64_t, std::size_t{kMaxWordsPerRow} * kMaxImageHeight_px> words_{};
};

}  // namespace articam::vision
