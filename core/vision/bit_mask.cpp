#include "core/vision/bit_mask.hpp"

#include <cstring>

namespace articam::vision {
namespace {

// Eight bytes of 0 or 1 into eight bits: the product brings byte i to bit 56 + i without a carry.
std::uint64_t gather_bits(const std::uint8_t* bytes) noexcept {
  static_assert(std::endian::native == std::endian::little, "byte i must have the weight 256^i");
  std::uint64_t spread;
  std::memcpy(&spread, bytes, sizeof spread);
  return (spread * 0x0102040810204080u) >> 56;
}

}  // namespace

int MaskRow::count(int a, int b) const noexcept {
  int sum = 0;
  for (int i = a >> 6; i <= b >> 6; ++i) {
    std::uint64_t bits = word(i);
    if (i == a >> 6) bits &= ~std::uint64_t{0} << (a & 63);
    if (i == b >> 6) bits &= ~std::uint64_t{0} >> (63 - (b & 63));
    sum += std::popcount(bits);
  }
  return sum;
}

void BitMask::binarise(const ImageView& image, const ThresholdMap& thresholds) noexcept {
  width_px_ = image.width_px;
  height_px_ = image.height_px;
  words_per_row_ = (image.width_px + 63) / 64;
  std::array<std::uint8_t, std::size_t{kMaxWordsPerRow} * 64> threshold, light;
  light.fill(0);
  for (int v = 0; v < height_px_; ++v) {
    if (v % kTile_px == 0) {
      const std::uint8_t* tiles = thresholds.tile_row(v / kTile_px);
      for (int i = 0; i < thresholds.tile_columns(); ++i)
        std::memset(&threshold[static_cast<std::size_t>(i * kTile_px)], tiles[i], kTile_px);
    }
    const std::uint8_t* grey = image.row(v);
    for (int u = 0; u < width_px_; ++u) {
      const auto i = static_cast<std::size_t>(u);
      light[i] = grey[u] >= threshold[i];
    }
    for (int i_word = 0; i_word < words_per_row_; ++i_word) {
      std::uint64_t bits = 0;
      for (int i = 0; i < 8; ++i) bits |= gather_bits(&light[static_cast<std::size_t>(i_word * 64 + i * 8)]) << (8 * i);
      words_[static_cast<std::size_t>(v * words_per_row_ + i_word)] = bits;
    }
  }
}

}  // namespace articam::vision
