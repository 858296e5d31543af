#pragma once
/// @file  Rings and dots in a grey frame: integers only, fixed capacity.

#include <cstdint>
#include <span>

#include "core/status.hpp"
#include "core/vision/binary_row.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/hole_offset.hpp"
#include "core/vision/image_view.hpp"
#include "core/vision/seed.hpp"
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
  Pinhole camera{};                    ///< tells where a hole is seen in its ring; else likely_pinhole() does

  constexpr bool ok() const noexcept {
    return !rings || (ring_ratio_q16 >= kMinRingRatio_q16 && ring_ratio_q16 <= kMaxRingRatio_q16 && camera.ok());
  }
};

/// A mark that is expected, by its outer edge.
struct Expected {
  MarkKind kind{};
  Ellipse outer{};
};

/// Search: grey -> threshold map -> rows of bits -> runs that may cross a mark -> chords -> seeds. Measurement: the
/// edges near a seed, fitted on the grey levels. Remembers nothing of earlier frames.
class Detector {
 public:
  explicit Detector(const DetectorOptions& options = {}) noexcept : options_{options} {}

  /// Every mark of the whole frame, in the order of its rows.
  /// Errors  bad_argument when the view may not be read (see ImageView::ok), or the rings' ratio or the camera's
  ///         numbers are out of range; `out` is unchanged then.
  Status detect(const ImageView& image, Detections& out) noexcept;

  /// Only marks that lie wholly inside one of the windows, each of them once.
  Status detect(const ImageView& image, std::span<const PixelBox> windows, Detections& out) noexcept;

  /// The same, added to the marks of this frame that `found` holds already.
  Status detect_more(const ImageView& image, std::span<const PixelBox> windows, Detections& found) noexcept;

  /// Measures where marks are expected, to a tenth of their diameter; reads nothing else of the frame. Those that are
  /// not there are left out, and those of kinds that the options do not seek.
  Status measure(const ImageView& image, std::span<const Expected> expected, Detections& out) noexcept;

  /// The last frame, or one of its windows, had more structure or marks than the fixed capacities hold.
  bool overloaded() const noexcept { return overloaded_; }

 private:
  struct View;
  bool may_read(const ImageView& image) const noexcept { return image.ok() && options_.ok(); }
  bool seeks(MarkKind kind) const noexcept;
  Pinhole camera_of(const ImageView& image) const noexcept;
  bool seeks_dots() const noexcept { return options_.dots_light_on_dark || options_.dots_dark_on_light; }
  void search(const ImageView& image, const PixelBox& window, Detections& found) noexcept;
  void search_row(const View& view, int v, Detections& found) noexcept;
  void inspect_ring(const View& view, const RowChord& chord, int v, Detections& found) noexcept;
  void inspect_dot(const View& view, int first, int end, int v, bool light, Detections& found) noexcept;
  bool is_known(const Detection& mark, const Detections& found) const noexcept;
  void keep(const Detection& mark, Detections& found) noexcept;

  DetectorOptions options_;
  bool overloaded_{};
  SearchLimits limits_{};
  ThresholdMap thresholds_;
  BinaryRow row_;
};

}  // namespace articam::vision
