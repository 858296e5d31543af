#pragma once
/// @file  A mark seen in an image.

#include <cstdint>

#include "core/config.hpp"
#include "core/fixed_vector.hpp"

namespace articam::vision {

enum class MarkKind : std::uint8_t { ring, dot_light_on_dark, dot_dark_on_light };

/// Q16: value_px * 65536 in an int32.
inline constexpr int kQ16 = 16;
constexpr double from_q16(std::int32_t q) noexcept { return static_cast<double>(q) / 65536.0; }

/// The ellipse { centre + M (cos t, sin t) }: M = | m00 0 ; m10 m11 |, lower triangular with a positive
/// diagonal, so that M M^T is the ellipse's shape matrix. All Q16 px.
struct Ellipse {
  std::int32_t u_q16{}, v_q16{};
  std::int32_t m00_q16{}, m10_q16{}, m11_q16{};
  constexpr bool operator==(const Ellipse&) const noexcept = default;
};

/// What may be wrong with a mark's image. Bits of Detection::flaws.
enum Flaw : std::uint8_t {
  kBlurred = 1,    ///< its edge is wider than kSharp_q8: out of focus, or moved while exposed
  kSaturated = 2,  ///< its light is at the end of the grey levels: the edge may be moved
  kOccluded = 4,   ///< up to an eighth of its edge is not seen, and was left out
  kClipped = 8,    ///< its dark is at the beginning of the grey levels: the edge may be moved
};
inline constexpr int kSharp_q8 = 3 * 256 / 2;  ///< standard deviation of an edge, px

struct Detection {
  MarkKind kind{};
  std::uint8_t flaws{};                 ///< of its outer edge: Flaw bits
  std::uint16_t blur_q8{};              ///< standard deviation of its outer edge, px, Q8
  Ellipse outer{};                      ///< outer edge of a ring, edge of a dot
  Ellipse inner{};                      ///< inner edge of a ring, as it is seen if light is even; zero otherwise
  std::uint32_t centre_variance_q24{};  ///< variance of u and of v of the outer centre, px^2, Q24
  std::uint32_t axis_variance_q24{};    ///< of each outer semi-axis, its bias included
  std::uint32_t inner_centre_variance_q24{}, inner_axis_variance_q24{};
  constexpr bool operator==(const Detection&) const noexcept = default;
};

using Detections = FixedVector<Detection, kMaxDetections>;

}  // namespace articam::vision
