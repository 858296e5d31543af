#include "core/vision/image_fault.hpp"

#include <algorithm>
#include <array>

namespace articam::vision {
namespace {

constexpr int kRowStep = 16;
constexpr int kWhite = 250;     // grey levels
constexpr int kBlack = 48;      // the noise of dark pixels included
constexpr int kContrast = 100;  // between the darkest and the brightest hundredth; marks are black on white

/// How many of the sampled pixels have each grey level.
class Histogram {
 public:
  void add(std::uint8_t grey) noexcept { ++count_[grey], ++total_; }

  /// The lowest level that a share of 1/256 x `n_256` of the pixels does not exceed.
  int level(std::int32_t n_256) const noexcept {
    std::int32_t seen = 0;
    std::size_t grey = 0;
    while (grey < 255 && (seen += count_[grey]) < total_ / 256 * n_256) ++grey;
    return static_cast<int>(grey);
  }

 private:
  std::array<std::int32_t, 256> count_{};
  std::int32_t total_{};
};

/// The largest rise or fall between the means of four pixels and of the next four, times 4: noise averages out.
int steepest_x4(const std::uint8_t* row, int width_px) noexcept {
  int steepest = 0, difference = 0;
  for (int u = 0; u + 8 <= width_px; ++u) {
    difference = 0;
    for (int k = 0; k < 4; ++k) difference += row[u + 4 + k] - row[u + k];
    steepest = std::max({steepest, difference, -difference});
  }
  return steepest;
}

}  // namespace

ImageFault fault_of(const ImageView& image) noexcept {
  Histogram histogram;
  int steepest = 0;
  for (int v = kRowStep / 2 < image.height_px ? kRowStep / 2 : 0; v < image.height_px; v += kRowStep) {
    const std::uint8_t* row = image.row(v);
    for (int u = 0; u < image.width_px; ++u) histogram.add(row[u]);
    steepest = std::max(steepest, steepest_x4(row, image.width_px));
  }
  const int dark = histogram.level(3), bright = histogram.level(253);
  if (bright < kBlack) return ImageFault::underexposed;
  if (histogram.level(192) >= kWhite) return ImageFault::overexposed;
  // Blurred by sigma s, a step rises by its height times 4 / (s sqrt(2 pi)) over four pixels: by half of it at sigma 3.
  // `steepest` is four times that.
  if (bright - dark >= kContrast && steepest < 2 * (bright - dark)) return ImageFault::blurred;
  return ImageFault::none;
}

}  // namespace articam::vision
