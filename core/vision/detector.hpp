#pragma once
/// @file  Rings and dots in a grey frame: integers only, fixed capacity.

#include <cstdint>
#include <span>

#include "core/status.hpp"
#include "core/vision/bit_mask.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/image_view.hpp"
#include "core/vision/mark.hpp"
#include "core/vision/threshold_map.hpp"

namespace articam::vision {

/// Rings with a smaller hole are dots at most distances, and of thinner ones neither edge has room for its fit.
inline constexpr std::int32_t kMinRingRatio_q16 = 3 << 12;  // 0.1875
inline constexpr std::int32_t kMaxRingRatio_q16 = 3 << 14;  // 0.75

struct DetectorOptions {
  bool rings{true};
  bool dots_light_on_dark{false};
  bool dots_dark_on_light{false};
  std::int32_t ring_ratio_q16{26859};  ///< inner : outer diameter, from kMin- to kMaxRingRatio; 50:122 is WhyCon's

  constexpr bool ok() const noexcept {
    return !rings || (ring_ratio_q16 >= kMinRingRatio_q16 && ring_ratio_q16 <= kMaxRingRatio_q16);
  }
};

/// grey -> threshold map -> bit mask -> outlines -> rings and dots -> edges fitted on the grey levels.
/// About 250 kB at the largest frame of config.hpp; remembers nothing of earlier frames.
class Detector {
 public:
  explicit Detector(const DetectorOptions& options = {}) noexcept : options_{options} {}

  /// Every mark of the whole frame, in the order of its rows.
  /// Errors  bad_argument when the view may not be read (see ImageView::ok), or the ratio of the rings is out of
  ///         range; `out` is unchanged then.
  Status detect(const ImageView& image, Detections& out) noexcept;

  /// Only marks that lie wholly inside one of the windows, each of them once.
  Status detect(const ImageView& image, std::span<const PixelBox> windows, Detections& out) noexcept;

  /// The last frame, or one of its windows, had more structure or marks than the fixed capacities hold.
  bool overloaded() const noexcept { return overloaded_; }

 private:
  void search(const ImageView& image, const PixelBox& window, Detections& found) noexcept;
  void search_row(const ImageView& image, Origin origin, int v, Colour colour, Detections& found) noexcept;
  void inspect(const ImageView& image, Origin origin, const Region& region, Detections& found) noexcept;

  DetectorOptions options_;
  bool overloaded_{};
  bool exhausted_{};  ///< the window being searched has used up a capacity
  int budget_{};      ///< work that may still be done in this window, in rows of outlines
  ThresholdMap thresholds_;
  BitMask mask_;
};

}  // namespace articam::vision
