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
/// nearest contrast, sought among about 9x9, 27x27 and 81x81 tiles. So a light gradient moves the threshold
/// along, and the inside of a mark of any size keeps its colour.
/// Source  the tiles of AprilTag's threshold (Wang & Olson, "AprilTag 2", IROS 2016), made multi-scale.
class ThresholdMap {
 public:
  static constexpr std::uint8_t kAllLight = 0, kAllDark = 255;

  /// Reads every second pair of rows of a view that is ok().
  void compute(const ImageView& image) noexcept;

  const std::uint8_t* tile_row(int i_row) const noexcept { return &threshold_[tiles_.index(i_row, 0)]; }
  int noise_gate() const noexcept { return gate_; }  ///< grey levels; noise alone differs by less

 private:
  /// Cells of one scale: single tiles, or 3^n x 3^n of them.
  struct Grid {
    int columns{}, rows{};
    std::size_t index(int i_row, int i_column) const noexcept {
      return static_cast<std::size_t>(i_row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i_column);
    }
    std::size_t size() const noexcept { return index(rows, 0); }
  };
  static constexpr std::size_t kMaxTiles = std::size_t{kMaxTileColumns} * kMaxTileRows;
  static constexpr std::size_t kMaxCells = std::size_t{kMaxTileColumns / 3 + 1} * (kMaxTileRows / 3 + 1);
  struct Coarse {
    Grid grid;
    std::array<std::uint8_t, kMaxCells> brightest, darkest;
    std::array<std::uint8_t, kMaxCells> middle;  ///< of the nearest contrast, 0 where there is none
  };
  static constexpr std::size_t kScales = 3;

  void reduce_to_tiles(const ImageView& image) noexcept;
  int find_noise_gate() const noexcept;
  void find_coarse_contrasts() noexcept;
  void decide() noexcept;
  static void dilate(const Grid& grid, std::uint8_t* map) noexcept;

  Grid tiles_;
  int gate_{};
  // Of each tile, then of the 3x3 around. darkest_ holds 255 - value, so that both grow by a maximum.
  std::array<std::uint8_t, kMaxTiles> brightest_{}, darkest_{}, threshold_{};
  std::array<Coarse, kScales> coarse_{};
};

}  // namespace articam::vision
