#pragma once
/// @file  Grey levels of a mark, and those on the other side of its middle.

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/vision/edge_profile.hpp"

namespace articam::vision {

/// Samples lie a step apart on a ray from the middle outwards. Windows of eight overlap, so that all but the first and
/// the last are between two others: steps 1 to 6, 7 to 12 (1.06 radii), and 13 and 14 (1.24) on the border of the mark.
inline constexpr std::int32_t kStep_q16 = kOne_q16 * 115 / 100 / 13;  ///< radii: the second window ends at 1.15
inline constexpr int kStepsInRing = 12, kStepsWithBorder = 14;

/// Something at each sample of a window.
using Lane = std::array<std::int32_t, kSamples>;

/// At each sample of a window, products summed over half a turn. S is the mean of two opposite points, smooth along the
/// turn (harmonics 0, 2 and 4); a and b are its slopes along the coordinates of the normalised plane, Q3 grey a step;
/// x and y are S times the direction of the ray, Q3 grey; D is one point less the other, Q4 grey.
struct OppositeSums {
  Lane aa{}, ab{}, bb{}, xx{}, xy{}, yy{}, ax{}, ay{}, bx{}, by{};
  Lane aD{}, bD{}, xD{}, yD{}, DD{};
};

/// Of a ring, by 32, 64 or 128 rays, to its edge or with its border.
class OppositePoints {
 public:
  OppositePoints(const ImageView& image, const Ellipse& ring, int rays, int steps) noexcept;

  /// use(sums, j, i, inside_q16) for sample j of those sums, i steps from the middle, which is its share of the area,
  /// with 1 - r^2 at its radius r; of the steps 1 to `steps`, not above those that were read.
  template <class Use>
  void for_each(int steps, Use use) const noexcept {
    for (int i = 1; i <= steps; ++i) {
      const std::size_t k = i <= kFirst[1] ? 0 : (i <= kStepsInRing ? 1 : 2);
      use(windows_[k], static_cast<std::size_t>(i - kFirst[k]), std::int64_t{i},
          kOne_q16 - (square(i * kStep_q16) >> 16));
    }
  }

  static constexpr int windows_of(int steps) noexcept { return steps <= kStepsInRing ? 2 : 3; }

 private:
  static constexpr std::array<int, 3> kFirst{0, 6, 8};  // steps at which windows begin
  static_assert(kFirst[1] + 2 == kSamples && kFirst[1] + kSamples - 2 == kStepsInRing &&
                kFirst[2] + kSamples - 2 == kStepsWithBorder);
  std::array<OppositeSums, 3> windows_;
};

}  // namespace articam::vision
