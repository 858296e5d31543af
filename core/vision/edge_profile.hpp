#pragma once
/// @file  Grey levels along rays across an elliptic edge, and the edge that they have in common.

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/vision/detection.hpp"
#include "core/vision/fixed_point.hpp"
#include "core/vision/image_view.hpp"

namespace articam::vision {

inline constexpr int kSamples = 8;  ///< along a ray: one 128-bit vector
inline constexpr int kMaxRays = kDirections;

/// Something at each sample of a ray.
using PerSample = std::array<std::int16_t, kSamples>;

/// Something of each ray.
using PerRay = std::array<std::int16_t, kMaxRays>;

/// Sample j of ray k is at [k][j]. Ray k points to k / rays of a turn, sample j lies at the radius
/// 1 + h (2 j / (kSamples - 1) - 1).
struct RaySamples {
  int rays{};
  alignas(16) std::array<PerSample, kMaxRays> grey_q4;                            ///< grey levels
  alignas(16) std::array<std::array<std::uint8_t, kSamples>, kMaxRays> right_q8;  ///< of the pixel's centre above and
  alignas(16) std::array<std::array<std::uint8_t, kSamples>, kMaxRays> down_q8;   ///< to the left, px, below 1
};

/// The number of rays that reads an edge of that mean radius about once in one and a half pixels: 32, 64 or 128.
int rays_around(std::int64_t radius_q16) noexcept;

/// Reads 16, 32, 64 or 128 rays in the window of +-h radii around the ellipse.
void read_rays(const ImageView& image, const Ellipse& e, std::int32_t half_window_q16, int rays,
               RaySamples& out) noexcept;

/// The edge as all rays together see it; along the ray in samples.
struct EdgeProfile {
  PerSample mean_q4;          ///< P
  PerSample slope_q4;         ///< D, 0 at both ends
  PerSample filter_q4;        ///< F = D |D| by its largest: what tells where a ray meets the edge
  std::int32_t contrast_q4;   ///< positive
  std::int64_t position_q16;  ///< of the edge, from the radius 1
  std::int64_t variance_q16;  ///< of the slope, the width of the edge squared
  bool saturated, clipped;    ///< its light, its dark is at the end of the grey levels
};

/// `sign` is 1 where it grows lighter outwards, -1 where darker. False where there is no such edge.
bool find_profile(const RaySamples& samples, int sign, EdgeProfile& out) noexcept;

/// Which rays cross a third of the mean step at least: all bits of them are set, of those that meet something in front
/// of the mark none is. Returns how many do not.
int find_crossings(const RaySamples& samples, int sign, const EdgeProfile& profile, PerRay& crosses) noexcept;

}  // namespace articam::vision
