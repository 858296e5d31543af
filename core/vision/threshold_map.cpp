#include "core/vision/threshold_map.hpp"

#include <algorithm>

namespace articam::vision {
namespace {

// Bounds of the noise gate, grey levels: quantisation and weak noise below, and above a frame of texture alone
// must not hide marks of moderate contrast.
constexpr int kMinGate = 10, kMaxGate = 40;

using Byte = std::uint8_t;
constexpr Byte larger(Byte a, Byte b) noexcept { return a > b ? a : b; }
constexpr Byte smaller(Byte a, Byte b) noexcept { return a < b ? a : b; }
constexpr Byte mean(Byte a, Byte b) noexcept { return static_cast<Byte>((a + b + 1) >> 1); }

// The loops below have plain pointers, a counted length and no branch: compilers turn them into vector instructions.

// Brightest and darkest of each column of four rows. Averages of row pairs instead of pixels: they halve the noise's
// power and cost one instruction.
void reduce_columns(const std::array<const Byte*, 4>& rows, int width, Byte* __restrict high,
                    Byte* __restrict low) noexcept {
  const Byte *r0 = rows[0], *r1 = rows[1], *r2 = rows[2], *r3 = rows[3];
  for (int u = 0; u < width; ++u) {
    const Byte a = mean(r0[u], r1[u]), b = mean(r2[u], r3[u]);
    high[u] = larger(a, b);
    low[u] = static_cast<Byte>(255 - smaller(a, b));
  }
}

// out[i] = largest of columns 8 i .. 8 i + 7, by doubling the reach three times.
void reduce_row(Byte* columns, int num_tiles, Byte* __restrict out) noexcept {
  for (const int reach : {1, 2, 4}) {
    for (int u = 0; u + reach < num_tiles * kTile_px; ++u) columns[u] = larger(columns[u], columns[u + reach]);
  }
  for (int i = 0; i < num_tiles; ++i) out[i] = columns[i * kTile_px];
}

}  // namespace

void ThresholdMap::compute(const ImageView& image) noexcept {
  tiles_ = {(image.width_px + kTile_px - 1) / kTile_px, (image.height_px + kTile_px - 1) / kTile_px};
  reduce_to_tiles(image);
  gate_ = find_noise_gate();
  dilate(tiles_, brightest_.data());
  dilate(tiles_, darkest_.data());
  find_coarse_contrasts();
  decide();
}

void ThresholdMap::reduce_to_tiles(const ImageView& image) noexcept {
  std::array<Byte, kMaxTileColumns * kTile_px> high, low;
  high.fill(0);  // beyond the image's width
  low.fill(0);
  for (int i_row = 0; i_row < tiles_.rows; ++i_row) {
    const auto row = [&](int v) { return image.row(std::min(i_row * kTile_px + v, image.height_px - 1)); };
    reduce_columns({row(1), row(2), row(5), row(6)}, image.width_px, high.data(), low.data());
    reduce_row(high.data(), tiles_.columns, &brightest_[tiles_.index(i_row, 0)]);
    reduce_row(low.data(), tiles_.columns, &darkest_[tiles_.index(i_row, 0)]);
  }
}

// Most images have a sixth of their tiles without structure: their range is noise, and that of nine tiles is half as
// large again. Less of a gate costs time in texture, more of it hides marks in the dark.
int ThresholdMap::find_noise_gate() const noexcept {
  std::array<std::uint16_t, 256> count{};
  static_assert(kMaxTiles < 65536);
  const std::size_t tiles = tiles_.size();
  for (std::size_t i = 0; i < tiles; ++i) ++count[static_cast<std::size_t>(brightest_[i] + darkest_[i] - 255)];
  std::size_t below = 0;
  int range = 0;
  while (range < 255 && (below += count[static_cast<std::size_t>(range)]) * 6 < tiles) ++range;
  return std::clamp(11 * range / 4, kMinGate, kMaxGate);
}

// Replaces each value by the largest of the 3x3 around it.
void ThresholdMap::dilate(const Grid& grid, Byte* map) noexcept {
  const int n = grid.columns;
  std::array<Byte, kMaxTileColumns + 2> tall{};
  std::array<Byte, kMaxTileColumns> above{}, here;
  Byte* __restrict column = tall.data();
  for (int i_row = 0; i_row < grid.rows; ++i_row) {
    Byte* __restrict row = map + grid.index(i_row, 0);
    const Byte* below = i_row + 1 < grid.rows ? row + n : row;
    for (int i = 0; i < n; ++i) here[static_cast<std::size_t>(i)] = row[i];
    for (int i = 0; i < n; ++i) column[i + 1] = larger(larger(above[static_cast<std::size_t>(i)], row[i]), below[i]);
    for (int i = 0; i < n; ++i) row[i] = larger(larger(column[i], column[i + 1]), column[i + 2]);
    above = here;
  }
}

// Each scale's cells are the nine of the finer one that a dilated value in their middle already holds.
void ThresholdMap::find_coarse_contrasts() noexcept {
  Grid fine = tiles_;
  const Byte *brightest = brightest_.data(), *darkest = darkest_.data();
  for (Coarse& scale : coarse_) {
    scale.grid = {(fine.columns + 2) / 3, (fine.rows + 2) / 3};
    for (int i_row = 0; i_row < scale.grid.rows; ++i_row) {
      for (int i = 0; i < scale.grid.columns; ++i) {
        const std::size_t middle =
            fine.index(std::min(3 * i_row + 1, fine.rows - 1), std::min(3 * i + 1, fine.columns - 1));
        scale.brightest[scale.grid.index(i_row, i)] = brightest[middle];
        scale.darkest[scale.grid.index(i_row, i)] = darkest[middle];
      }
    }
    dilate(scale.grid, scale.brightest.data());
    dilate(scale.grid, scale.darkest.data());
    fine = scale.grid, brightest = scale.brightest.data(), darkest = scale.darkest.data();
  }
  const int gate = gate_ * 3 / 2;  // noise reaches further among so many more pixels
  for (std::size_t k = kScales; k-- > 0;) {
    Coarse& scale = coarse_[k];
    for (int i_row = 0; i_row < scale.grid.rows; ++i_row) {
      for (int i = 0; i < scale.grid.columns; ++i) {
        const std::size_t cell = scale.grid.index(i_row, i);
        const int low = 255 - scale.darkest[cell], high = scale.brightest[cell];
        const Byte coarser =
            k + 1 < kScales ? coarse_[k + 1].middle[coarse_[k + 1].grid.index(i_row / 3, i / 3)] : Byte{0};
        scale.middle[cell] = high - low >= gate ? static_cast<Byte>((high + low + 1) / 2) : coarser;
      }
    }
  }
}

void ThresholdMap::decide() noexcept {
  const Coarse& scale = coarse_[0];
  std::array<Byte, kMaxTileColumns + 3> middle;
  const Byte gate = static_cast<Byte>(gate_);
  const int n = tiles_.columns;
  for (int i_row = 0; i_row < tiles_.rows; ++i_row) {
    const int cells = i_row % 3 == 0 ? scale.grid.columns : 0;  // one row of cells covers three of tiles
    for (int i = 0; i < cells; ++i) {
      const Byte value = scale.middle[scale.grid.index(i_row / 3, i)];
      for (int k = 0; k < 3; ++k) middle[static_cast<std::size_t>(3 * i + k)] = value;
    }
    const std::size_t first = tiles_.index(i_row, 0);
    const Byte *brightest = &brightest_[first], *darkest = &darkest_[first];
    Byte* __restrict threshold = &threshold_[first];
    const Byte* nearest = middle.data();
    for (int i = 0; i < n; ++i) {  // in bytes throughout
      const Byte low = static_cast<Byte>(255 - darkest[i]), high = brightest[i];
      const Byte rounded_down = static_cast<Byte>(255 - mean(darkest[i], static_cast<Byte>(255 - high)));
      const Byte flat = rounded_down < nearest[i] ? kAllDark : kAllLight;
      threshold[i] = static_cast<Byte>(high - low) >= gate ? mean(low, high) : flat;
    }
  }
}

}  // namespace articam::vision
