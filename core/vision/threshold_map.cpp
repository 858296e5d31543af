#include "core/vision/threshold_map.hpp"

#include <algorithm>
#include <cstring>

namespace articam::vision {
namespace {

constexpr std::uint8_t kAllLight = 0, kAllDark = 255;
constexpr std::uint8_t kUndecided = 1;  // never the middle of two values that differ by kMinGate or more

// Bounds of the noise gate, grey levels: quantisation and weak noise below, and above a frame of texture alone
// must not hide marks of moderate contrast.
constexpr int kMinGate = 10, kMaxGate = 40;

constexpr int kCoarsestStep = 27;

std::uint8_t larger(std::uint8_t a, std::uint8_t b) noexcept { return a > b ? a : b; }

std::uint8_t largest_of_tile(const std::uint8_t* values) noexcept {
  std::uint8_t result = 0;
  for (int i = 0; i < kTile_px; ++i) result = larger(result, values[i]);
  return result;
}

// Plain pointers and a local count, so that compilers turn it into vector instructions.
void raise_to_pair(const std::uint8_t* above, const std::uint8_t* below, std::size_t width, std::uint8_t* high,
                   std::uint8_t* low) noexcept {
  for (std::size_t u = 0; u < width; ++u) {
    const auto mean = static_cast<std::uint8_t>((above[u] + below[u] + 1) >> 1);
    const auto inverse = static_cast<std::uint8_t>(~mean);
    const std::uint8_t old_high = high[u], old_low = low[u];
    high[u] = larger(old_high, mean);
    low[u] = larger(old_low, inverse);
  }
}

}  // namespace

void ThresholdMap::compute(const ImageView& image) noexcept {
  columns_ = (image.width_px + kTile_px - 1) / kTile_px;
  rows_ = (image.height_px + kTile_px - 1) / kTile_px;
  reduce_to_tiles(image);
  const int gate = noise_gate();
  for (int step = 1; step <= kCoarsestStep; step *= 3) {
    dilate(brightest_, step);
    dilate(darkest_, step);
    if (step == 1)
      decide_textured(gate);
    else
      decide_flat(gate * 3 / 2);  // noise reaches further among so many more pixels
  }
  std::replace(threshold_.begin(), threshold_.begin() + static_cast<std::ptrdiff_t>(tiles()), kUndecided, kAllLight);
}

// Averages of row pairs instead of pixels: they halve the noise's power and cost one instruction.
void ThresholdMap::reduce_to_tiles(const ImageView& image) noexcept {
  const auto width = static_cast<std::size_t>(image.width_px);
  std::array<std::uint8_t, kMaxTileColumns * kTile_px> high, low;
  for (int i_row = 0; i_row < rows_; ++i_row) {
    high.fill(0);
    low.fill(0);
    const int v_end = std::min((i_row + 1) * kTile_px, image.height_px);
    for (int v = i_row * kTile_px; v < v_end; v += 2) {
      const std::uint8_t* above = image.row(v);
      const std::uint8_t* below = image.row(std::min(v + 1, v_end - 1));
      raise_to_pair(above, below, width, high.data(), low.data());
    }
    for (int i_column = 0; i_column < columns_; ++i_column) {
      const auto from = static_cast<std::size_t>(i_column * kTile_px), tile = offset(i_row) + from / kTile_px;
      brightest_[tile] = largest_of_tile(&high[from]);
      darkest_[tile] = largest_of_tile(&low[from]);
    }
  }
}

// Most images have a sixth of their tiles without structure: their range is noise.
int ThresholdMap::noise_gate() const noexcept {
  std::array<std::uint16_t, 256> count{};
  static_assert(kMaxTiles < 65536);
  for (std::size_t i = 0; i < tiles(); ++i) ++count[static_cast<std::size_t>(brightest_[i] + darkest_[i] - 255)];
  std::size_t below = 0;
  int range = 0;
  while (range < 255 && (below += count[static_cast<std::size_t>(range)]) * 6 < tiles()) ++range;
  return std::clamp(2 * range, kMinGate, kMaxGate);
}

// Replaces each value by the largest of the 3x3 values `step` tiles apart; the border repeats its last value.
void ThresholdMap::dilate(Map& map, int step) noexcept {
  for (int i_row = 0; i_row < rows_; ++i_row) {
    const std::uint8_t* above = &map[offset(std::max(i_row - step, 0))];
    const std::uint8_t* here = &map[offset(i_row)];
    const std::uint8_t* below = &map[offset(std::min(i_row + step, rows_ - 1))];
    std::uint8_t* out = &scratch_[offset(i_row)];
    for (int i = 0; i < columns_; ++i) out[i] = larger(larger(above[i], below[i]), here[i]);
  }
  std::array<std::uint8_t, kMaxTileColumns + 2 * kCoarsestStep> padded;
  const auto columns = static_cast<std::size_t>(columns_), pad = static_cast<std::size_t>(step);
  for (int i_row = 0; i_row < rows_; ++i_row) {
    const std::uint8_t* in = &scratch_[offset(i_row)];
    std::memset(padded.data(), in[0], pad);
    std::memcpy(padded.data() + pad, in, columns);
    std::memset(padded.data() + pad + columns, in[columns - 1], pad);
    std::uint8_t* out = &map[offset(i_row)];
    for (std::size_t i = 0; i < columns; ++i) {
      out[i] = larger(larger(padded[i], padded[i + 2 * pad]), padded[i + pad]);
    }
  }
}

void ThresholdMap::decide_textured(int gate) noexcept {
  for (std::size_t i = 0; i < tiles(); ++i) {
    const int low = 255 - darkest_[i], high = brightest_[i];
    level_[i] = static_cast<std::uint8_t>((high + low + 1) / 2);
    threshold_[i] = high - low >= gate ? level_[i] : kUndecided;
  }
}

void ThresholdMap::decide_flat(int gate) noexcept {
  for (std::size_t i = 0; i < tiles(); ++i) {
    const int low = 255 - darkest_[i], high = brightest_[i];
    if (threshold_[i] != kUndecided || high - low < gate) continue;
    threshold_[i] = 2 * level_[i] >= high + low ? kAllLight : kAllDark;
  }
}

}  // namespace articam::vision
