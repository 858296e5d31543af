#include "core/vision/region.hpp"

#include <algorithm>

#include "core/vision/fixed_point.hpp"

namespace articam::vision {
namespace {

// Sum of i and of i^2 for i = a .. b.
constexpr std::int64_t sum_to(std::int64_t n) noexcept { return n * (n + 1) / 2; }
constexpr std::int64_t sum_of_squares_to(std::int64_t n) noexcept { return n * (n + 1) * (2 * n + 1) / 6; }

void add_row(const MaskRow& row, int v, int left, int right, Region& region) noexcept {
  const std::int64_t n = right - left + 1, a = left - region.u0_px, b = right - region.u0_px, dv = v - region.v0_px;
  const std::int64_t sum_u = sum_to(b) - sum_to(a - 1);
  region.area += n;
  region.own += row.count(left, right);
  region.sum_u += sum_u;
  region.sum_v += n * dv;
  region.sum_uu += sum_of_squares_to(b) - sum_of_squares_to(a - 1);
  region.sum_uv += sum_u * dv;
  region.sum_vv += n * dv * dv;
  region.box.u_min_px = std::min(region.box.u_min_px, left);
  region.box.u_max_px = std::max(region.box.u_max_px, right);
  region.box.v_max_px = v;
}

int longest_run(const MaskRow& row, int from, int to, int& budget) noexcept {
  constexpr int kRunsPerRow = 8;  // cost about as much as one row of an outline
  int longest = 0, runs = 0;
  for (int u = row.next_set(from); u <= to; ++runs) {
    const int end = row.next_clear(u);
    longest = std::max(longest, end - u);
    u = row.next_set(end);
  }
  budget -= runs / kRunsPerRow;
  return longest;
}

// Of several outlines that meet in the next row only the widest goes on (the leftmost of equals): ragged tops do
// not lose a mark, and no row of a region is walked once for every top above it.
bool another_is_wider(const MaskRow& row, int left, int right, int next_left, int next_right, int& budget) noexcept {
  const int width = right - left + 1;
  if (next_left < left && longest_run(row, std::max(next_left - 1, 0), left - 2, budget) >= width) return true;
  return next_right > right && longest_run(row, right + 2, next_right + 1, budget) > width;
}

// At least 1/5 as wide as long (78 deg of tilt), and the area is pi m00 m11 but for the pixels of a ragged outline.
bool is_plausible(std::int64_t m00_q16, std::int64_t m10_q16, std::int64_t m11_q16, std::int64_t area) noexcept {
  const std::int64_t product_q16 = m00_q16 * m11_q16 >> kQ16;
  const std::int64_t squares_q16 = (m00_q16 * m00_q16 + m10_q16 * m10_q16 + m11_q16 * m11_q16) >> kQ16;
  if (26 * product_q16 < 5 * squares_q16) return false;
  constexpr std::int64_t kPi_q8 = 804;
  const std::int64_t expected = product_q16 * kPi_q8 >> (kQ16 + 8);
  const std::int64_t off = area > expected ? area - expected : expected - area;
  return off <= expected / 8 + 2;
}

}  // namespace

bool trace_region(const BitMask& mask, Colour colour, int v, int a, int b, std::int32_t min_own_q16, int& budget,
                  Region& out) noexcept {
  Region region{.colour = colour, .u0_px = a, .v0_px = v, .box = {a, v, b, v}};
  int left = a, right = b;
  if (left < 1 || right > mask.width_px() - 2) return false;
  for (;; ++v) {
    if (v > mask.height_px() - 2 || --budget < 0) return false;
    const MaskRow row = mask.row(v, colour);
    add_row(row, v, left, right, region);
    if (region.own * kOne_q16 < region.area * min_own_q16) return false;

    const MaskRow next = mask.row(v + 1, colour);
    const int first = next.next_set(left - 1);
    if (first > right + 1) break;
    const int last = next.last_set(right + 1);
    const int next_left = first == left - 1 ? next.last_clear(first) + 1 : first;
    const int next_right = last == right + 1 ? next.next_clear(last) - 1 : last;
    if (next_left < 1 || next_right > mask.width_px() - 2) return false;
    if ((next_left < left || next_right > right) && another_is_wider(row, left, right, next_left, next_right, budget))
      return false;
    left = next_left;
    right = next_right;
  }
  out = region;
  return true;
}

bool ellipse_of(const Region& region, Ellipse& out) noexcept {
  constexpr std::int64_t kMaxArea = std::int64_t{kMaxImageWidth_px} * kMaxImageHeight_px;
  constexpr std::int64_t kMaxSide = std::max(kMaxImageWidth_px, kMaxImageHeight_px);
  static_assert(kMaxArea < (std::int64_t{1} << 62) / (kMaxArea * kMaxSide * kMaxSide), "n * sum_uu fits");
  static_assert(kMaxArea * kMaxSide * kMaxSide < std::int64_t{1} << 42, "4 n var, Q20, fits");

  // An ellipse with semi-axes a, b has variances a^2/4, b^2/4 along them: its shape M M^T is 4 times the covariance
  // of its points, to which each pixel's own extent adds 1/12 px^2.
  const std::int64_t n = region.area;
  const auto shape_q20 = [n](std::int64_t sum_xy, std::int64_t sum_x, std::int64_t sum_y) {
    const std::int64_t n_cov = (n * sum_xy - sum_x * sum_y) / n;
    return n_cov * (std::int64_t{1} << 20) / n * 4;
  };
  constexpr std::int64_t kPixelExtent_q20 = (4 << 20) / 12;
  const std::int64_t uu_q20 = shape_q20(region.sum_uu, region.sum_u, region.sum_u) + kPixelExtent_q20;
  const std::int64_t uv_q20 = shape_q20(region.sum_uv, region.sum_u, region.sum_v);
  const std::int64_t vv_q20 = shape_q20(region.sum_vv, region.sum_v, region.sum_v) + kPixelExtent_q20;
  const std::int64_t m00 = integer_sqrt(static_cast<std::uint64_t>(uu_q20) << 12);  // Q16, as all below
  const std::int64_t m10 = uv_q20 * (1 << 12) / m00;
  const std::int64_t m11_squared_q32 = vv_q20 * (1 << 12) - m10 * m10;
  if (m11_squared_q32 <= 0) return false;
  const std::int64_t m11 = integer_sqrt(static_cast<std::uint64_t>(m11_squared_q32));

  if (!is_plausible(m00, m10, m11, n)) return false;
  out.u_q16 = static_cast<std::int32_t>((region.u0_px * n + region.sum_u) * kOne_q16 / n);
  out.v_q16 = static_cast<std::int32_t>((region.v0_px * n + region.sum_v) * kOne_q16 / n);
  out.m00_q16 = static_cast<std::int32_t>(m00);
  out.m10_q16 = static_cast<std::int32_t>(m10);
  out.m11_q16 = static_cast<std::int32_t>(m11);
  return true;
}

}  // namespace articam::vision
