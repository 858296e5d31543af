#pragma once
/// @file  Grey image -> one threshold for each tile, chosen from the contrast around it.

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/config.hpp"
#include "core/vision/image_view.hpp"

namespace articam::vision {

inline constexpr int kTile_px = 8;
inline constexpr int kMaxTileColumns = (kMaxImageWidth_px + kTile_px - 1) / kTile_px;
inline constexpr int kMaxTileRows = (kMaxImageHeight_px + kTile_px - 1) / kTile_px;

/// A pixel is light where it is not below its tile's threshold.
///
/// The threshold is the middle between the darkest and the brightest of the 3x3 tiles around. Where they
/// differ by no more than noise, the tile is flat and wholly light or dark: the side of the middle of the
/// nearest contrast, sought among 9x9, 27x27 and 81x81 tiles. So a light gradient moves the threshold
/// along, and the inside of a mark of any size keeps its colour.
/// Source  the tiles of AprilTag's threshold (Wang & Olson, "AprilTag 2", IROS 2016), made multi-scale.
class ThresholdMap {
 public:
  /// Reads every pixel of a view that is ok().
  void compute(const ImageView& image) noexcept;

  const std::uint8_t* tile_row(int i_row) const noexcept { return &threshold_[offset(i_row)]; }
  int tile_columns() const noexcept { return columns_; }

 private:
  static constexpr std::size_t kMaxTiles = std::size_t{kMaxTileColumns} * kMaxTileRows;
  using Map = std::array<std::uint8_t, kMaxTiles>;

  std::size_t offset(int i_row) const noexcept {
    return static_cast<std::size_t>(i_row) * static_cast<std::size_t>(columns_);
  }
  std::size_t tiles() const noexcept { return offset(rows_); }
  void reduce_to_tiles(const ImageView& image) noexcept;
  int noise_gate() const noexcept;
  void dilate(Map& map, int step) noexcept;
  void decide_textured(int gate) noexcept;
  void decide_flat(int gate) noexcept;

  int columns_{}, rows_{};
  Map brightest_{}, darkest_{};  ///< darkest is kept as 255 - value, so that both grow by a maximum
  Map threshold_{}, level_{};    ///< level: middle grey of the 3x3 tiles around
  Map scratch_{};
};

}  // namespace articam::vision
