#pragma once
/// @file  Grey levels of a mark, and those on the other side of its middle.

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/vision/edge_profile.hpp"

namespace articam::vision {

/// 13 samples lie a step apart on a ray from the middle to 1.15 radii. Two windows of eight show them, two of them
/// twice, so that all but the first and the last are between two others.
inline constexpr int kSteps = 13, kStepWindows = 2;
inline constexpr std::array<int, kStepWindows> kFirstStep{0, 6};
inline constexpr std::int32_t kStep_q16 = 23 * kOne_q16 / 20 / kSteps;  ///< radii
static_assert(kFirstStep.back() + kSamples - 1 == kSteps);

/// Something at each sample of a window.
using Lane = std::array<std::int32_t, kSamples>;

/// At each sample of a window, products summed over half a turn: of the slopes of S along a and b, the coordinates of
/// the normalised plane, Q3 grey a step, and of D, Q4 grey. S is the mean of the two opposite points, smooth along the
/// turn (harmonics 0, 2 and 4), D the one less the other.
struct OppositeSums {
  Lane aa{}, ab{}, bb{}, aD{}, bD{}, DD{};
};

/// Of a ring, by 32, 64 or 128 rays.
class OppositePoints {
 public:
  OppositePoints(const ImageView& image, const Ellipse& ring, int rays) noexcept;

  /// use(sums, j, i, inside_q16) for sample j of those sums, i steps from the middle, which is its share of the area,
  /// with 1 - r^2 at its radius r; of every sample between two others.
  template <class Use>
  void for_each(Use use) const noexcept {
    for (std::size_t k = 0; k < kStepWindows; ++k)
      for (std::size_t j = 1; j + 1 < kSamples; ++j) {
        const std::int64_t i = kFirstStep[k] + static_cast<std::int64_t>(j);
        use(windows_[k], j, i, kOne_q16 - (square(i * kStep_q16) >> 16));
      }
  }

 private:
  std::array<OppositeSums, kStepWindows> windows_;
};

}  // namespace articam::vision
