#include "core/vision/detector.hpp"

#include <algorithm>
#include <bit>

namespace articam::vision {
namespace {

// Work is bounded on any frame or window: one row of an outline for each so many pixels, above what any scene of
// marks needs, and what a small window's marks need.
constexpr int kPixelsPerRow = 16;
constexpr int kMinRowBudget = 1024;

// A word of 64 pixels with more changes than this is texture finer than the edges of the smallest marks.
constexpr int kMaxChangesPerWord = 24;

/// Pixels of a colour with no pixel of that colour in the row above: beside, straight or diagonally.
std::uint64_t fresh(const MaskRow& above, const MaskRow& row, int i) noexcept {
  const std::uint64_t here = row.word(i), over = above.word(i);
  const std::uint64_t before = i > 0 ? above.word(i - 1) >> 63 : 0;
  const std::uint64_t after = i + 1 < row.num_words ? above.word(i + 1) << 63 : 0;
  return here & ~(over | over << 1 | before | over >> 1 | after);
}

bool same_place(const Detection& a, const Detection& b) noexcept {
  const std::int64_t du = a.outer.u_q16 - b.outer.u_q16, dv = a.outer.v_q16 - b.outer.v_q16;
  const std::int64_t m00 = b.outer.m00_q16, m11 = b.outer.m11_q16;
  return du * du + dv * dv < std::min(m00 * m00, m11 * m11) / 4;
}

bool in_a_ring(const Detection& dot, const Detections& found) noexcept {
  return std::any_of(found.begin(), found.end(),
                     [&](const Detection& ring) { return ring.kind == MarkKind::ring && same_place(dot, ring); });
}

}  // namespace

Status Detector::detect(const ImageView& image, Detections& out) noexcept {
  const PixelBox whole{0, 0, image.width_px - 1, image.height_px - 1};
  return detect(image, {&whole, 1}, out);
}

Status Detector::detect(const ImageView& image, std::span<const PixelBox> windows, Detections& out) noexcept {
  if (!image.ok() || !options_.ok()) return Status::bad_argument;
  overloaded_ = false;
  out.clear();
  for (const PixelBox& window : windows) {
    const PixelBox box = window.clipped_to(image);
    if (box.empty()) continue;
    search(image, box, out);
    overloaded_ |= exhausted_;
  }
  const auto is_before = [](const Detection& a, const Detection& b) {
    return a.outer.v_q16 != b.outer.v_q16 ? a.outer.v_q16 < b.outer.v_q16 : a.outer.u_q16 < b.outer.u_q16;
  };
  // By insertion: std::sort calls itself, and the stack of a step must have a bound.
  for (Detection* next = out.begin(); next != out.end(); ++next) {
    std::rotate(std::upper_bound(out.begin(), next, *next, is_before), next, next + 1);
  }
  return Status::ok;
}

void Detector::search(const ImageView& image, const PixelBox& window, Detections& found) noexcept {
  const ImageView view{image.row(window.v_min_px) + window.u_min_px, window.u_max_px - window.u_min_px + 1,
                       window.v_max_px - window.v_min_px + 1, image.stride_bytes};
  thresholds_.compute(view);
  mask_.binarise(view, thresholds_);
  exhausted_ = false;
  budget_ = kMinRowBudget + view.width_px * view.height_px / kPixelsPerRow;
  const Origin origin{window.u_min_px, window.v_min_px};
  for (int v = 1; v + 1 < view.height_px && !exhausted_; ++v) {
    if (options_.rings || options_.dots_dark_on_light) search_row(image, origin, v, Colour::dark, found);
    if (options_.dots_light_on_dark) search_row(image, origin, v, Colour::light, found);
  }
}

// A run with nothing of its colour above may be the top of a mark.
void Detector::search_row(const ImageView& image, Origin origin, int v, Colour colour, Detections& found) noexcept {
  const std::int32_t min_own_q16 = least_own_share_q16(options_.ring_ratio_q16);
  const MaskRow above = mask_.row(v - 1, colour), row = mask_.row(v, colour);
  for (int i = 0; i < row.num_words; ++i) {
    const std::uint64_t here = row.word(i);
    const std::uint64_t carry = i > 0 ? row.word(i - 1) >> 63 : 0;
    std::uint64_t starts = here & ~(here << 1 | carry) & fresh(above, row, i);
    if (starts == 0 || std::popcount(here ^ here << 1) > kMaxChangesPerWord) continue;
    for (; starts != 0; starts &= starts - 1) {
      const int left = i * 64 + std::countr_zero(starts), right = row.next_clear(left) - 1;
      if (left == 0 || above.next_set(left - 1) <= right + 1) continue;
      Region region;
      if (trace_region(mask_, colour, v, left, right, min_own_q16, budget_, region))
        inspect(image, origin, region, found);
      if (budget_ <= 0) exhausted_ = true;
      if (exhausted_) return;
    }
  }
}

void Detector::inspect(const ImageView& image, Origin origin, const Region& region, Detections& found) noexcept {
  constexpr int kMinSide_px = 3;
  if (region.box.u_max_px - region.box.u_min_px + 1 < kMinSide_px) return;
  if (region.box.v_max_px - region.box.v_min_px + 1 < kMinSide_px) return;
  Detection mark;
  const bool dots = region.colour == Colour::dark ? options_.dots_dark_on_light : options_.dots_light_on_dark;
  const bool ring = options_.rings && region.colour == Colour::dark &&
                    find_ring(image, mask_, origin, region, options_.ring_ratio_q16, budget_, mark);
  if (!ring && !(dots && find_dot(image, origin, region, budget_, mark))) return;
  if (!ring && in_a_ring(mark, found)) return;
  const auto twin = [&](const Detection& other) { return other.kind == mark.kind && same_place(mark, other); };
  if (std::none_of(found.begin(), found.end(), twin) && !found.push_back(mark)) exhausted_ = true;
}

}  // namespace articam::vision
