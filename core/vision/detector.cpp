#include "core/vision/detector.hpp"

#include <algorithm>
#include <bit>

#include "core/vision/fixed_point.hpp"
#include "core/vision/mark.hpp"

namespace articam::vision {
namespace {

// A word of 64 pixels with more changes than this is texture finer than the edges of the smallest marks.
constexpr int kMaxChangesPerWord = 24;

// Work is bounded on any frame or window: so many pixels looked at again for each pixel of the frame, half of them
// given out as the search goes down, so that texture at the top does not use up what marks at the bottom need. Every
// run may be a dot, but few chords may cross a ring.
constexpr int kLooksForRings_q4 = 12, kLooksForDots_q4 = 64, kMinLooks = 16384;

// A target without an instruction for it calls a function for std::popcount.
int count_bits(std::uint64_t x) noexcept {
  x -= x >> 1 & 0x5555555555555555u;
  x = (x & 0x3333333333333333u) + (x >> 2 & 0x3333333333333333u);
  return static_cast<int>(((x + (x >> 4)) & 0x0f0f0f0f0f0f0f0fu) * 0x0101010101010101u >> 56);
}

// Within half of the second's smaller extent; most marks are of other rows.
bool same_place(const Detection& a, const Detection& b) noexcept {
  const std::int32_t near = std::min(b.outer.m00_q16, b.outer.m11_q16) / 2;
  const std::int32_t dv = a.outer.v_q16 - b.outer.v_q16;
  if (dv >= near || -dv >= near) return false;
  const std::int64_t du = a.outer.u_q16 - b.outer.u_q16;
  return du * du + square(dv) < square(near);
}

// Of numbers that a mark in this frame may have, the fit's integers hold all that follows; others are no expectation.
bool may_be_in(const ImageView& image, const Ellipse& e) noexcept {
  const auto is_between = [](std::int64_t least, std::int64_t x_q16, int most_px) {
    return x_q16 >= least && x_q16 <= std::int64_t{most_px} * kOne_q16;
  };
  return is_between(0, e.u_q16, image.width_px - 1) && is_between(0, e.v_q16, image.height_px - 1) &&
         is_between(kOne_q16, e.m00_q16, image.width_px) && is_between(kOne_q16, e.m11_q16, image.height_px) &&
         is_between(-std::int64_t{image.height_px} * kOne_q16, e.m10_q16, image.height_px);
}

// By insertion: std::sort calls itself, and the stack of a step must have a bound.
void sort_by_rows(Detections& marks) noexcept {
  const auto is_before = [](const Detection& a, const Detection& b) {
    return a.outer.v_q16 != b.outer.v_q16 ? a.outer.v_q16 < b.outer.v_q16 : a.outer.u_q16 < b.outer.u_q16;
  };
  for (Detection* next = marks.begin(); next != marks.end(); ++next) {
    std::rotate(std::upper_bound(marks.begin(), next, *next, is_before), next, next + 1);
  }
}

}  // namespace

/// A window of the image, and where it lies there.
struct Detector::View {
  const ImageView& image;
  ImageView window;
  int u_px, v_px;

  Ellipse in_image(Ellipse e) const noexcept {
    e.u_q16 += u_px * kOne_q16;
    e.v_q16 += v_px * kOne_q16;
    return e;
  }
};

Status Detector::detect(const ImageView& image, Detections& out) noexcept {
  const PixelBox whole{0, 0, image.width_px - 1, image.height_px - 1};
  return detect(image, {&whole, 1}, out);
}

Status Detector::detect(const ImageView& image, std::span<const PixelBox> windows, Detections& out) noexcept {
  if (!may_read(image)) return Status::bad_argument;
  out.clear();
  return detect_more(image, windows, out);
}

Status Detector::detect_more(const ImageView& image, std::span<const PixelBox> windows, Detections& found) noexcept {
  if (!may_read(image)) return Status::bad_argument;
  overloaded_ = false;
  for (const PixelBox& window : windows) {
    const PixelBox box = window.clipped_to(image);
    if (!box.empty()) search(image, box, found);
  }
  sort_by_rows(found);
  return Status::ok;
}

Status Detector::measure(const ImageView& image, std::span<const Expected> expected, Detections& out) noexcept {
  if (!may_read(image)) return Status::bad_argument;
  overloaded_ = false;
  out.clear();
  for (const Expected& mark : expected) {
    if (!seeks(mark.kind) || !may_be_in(image, mark.outer)) continue;
    int unlimited = 0;  // a fit is bounded by itself, and there are only so many
    Detection found;
    const bool there =
        mark.kind == MarkKind::ring
            ? measure_ring(image, mark.outer, options_.ring_ratio_q16, camera_of(image), unlimited, found)
            : measure_dot(image, mark.outer, mark.kind == MarkKind::dot_light_on_dark, unlimited, found);
    if (there) keep(found, out);
  }
  sort_by_rows(out);
  return Status::ok;
}

bool Detector::seeks(MarkKind kind) const noexcept {
  if (kind == MarkKind::ring) return options_.rings;
  return kind == MarkKind::dot_light_on_dark ? options_.dots_light_on_dark : options_.dots_dark_on_light;
}

Pinhole Detector::camera_of(const ImageView& image) const noexcept {
  return options_.camera.known() ? options_.camera : likely_pinhole(image.width_px, image.height_px);
}

void Detector::search(const ImageView& image, const PixelBox& box, Detections& found) noexcept {
  const View view{image,
                  {image.row(box.v_min_px) + box.u_min_px, box.u_max_px - box.u_min_px + 1,
                   box.v_max_px - box.v_min_px + 1, image.stride_bytes},
                  box.u_min_px,
                  box.v_min_px};
  const ImageView& window = view.window;
  thresholds_.compute(window);
  const int looks_q4 = seeks_dots() ? kLooksForDots_q4 : kLooksForRings_q4;
  const int looks = kMinLooks + window.width_px * window.height_px / 16 * looks_q4;
  const int tile_rows = (window.height_px + kTile_px - 1) / kTile_px;
  limits_ = {.least_contrast = thresholds_.noise_gate() * 2 / 3, .budget = looks / 2};
  for (int i_row = 0; i_row < tile_rows; ++i_row) {
    limits_.budget = std::max(limits_.budget, 0) + looks / 2 / tile_rows;
    row_.set_thresholds(thresholds_.tile_row(i_row), window.width_px);
    // Every second row: the hole of the smallest mark is higher than one.
    for (int v = i_row * kTile_px + 1; v < std::min((i_row + 1) * kTile_px, window.height_px - 1); v += 2) {
      row_.compute(window.row(v));
      search_row(view, v, found);
      if (limits_.budget < 0 || found.full()) overloaded_ = true;
    }
  }
}

void Detector::search_row(const View& view, int v, Detections& found) noexcept {
  constexpr int kFar = -16 * kMaxImageWidth_px;  // no chord with such an end may cross a mark
  static_assert(!may_cross_ring({kFar, kFar, 0, kMaxImageWidth_px}, kMaxRingRatio_q16 >> 8));
  const std::int32_t ratio_q8 = options_.rings ? options_.ring_ratio_q16 >> 8 : 0;  // only of rings it was checked
  const bool dots = seeks_dots();
  int first = kFar, inner_first = kFar, inner_end = kFar, end = kFar;  // one by one, so that they stay in registers
  std::uint64_t before = row_.word(0) & 1;
  for (int i = 0; i < row_.num_words() && limits_.budget >= 0 && !found.full(); ++i) {
    const std::uint64_t here = row_.word(i);
    std::uint64_t changes = here ^ (here << 1 | before);
    before = here >> 63;
    if (changes == 0) continue;
    if (count_bits(changes) > kMaxChangesPerWord) {
      first = inner_first = inner_end = end = kFar;
      continue;
    }
    for (; changes != 0; changes &= changes - 1) {
      const int bit = std::countr_zero(changes);
      const bool turns_light = (here >> bit & 1) != 0;
      first = inner_first, inner_first = inner_end, inner_end = end, end = i * 64 + bit;
      if (dots && (turns_light ? options_.dots_dark_on_light : options_.dots_light_on_dark))
        inspect_dot(view, inner_end, end, v, !turns_light, found);
      if (turns_light && may_cross_ring({first, inner_first, inner_end, end}, ratio_q8))
        inspect_ring(view, {first, inner_first, inner_end, end}, v, found);
    }
  }
}

void Detector::inspect_ring(const View& view, const RowChord& chord, int v, Detections& found) noexcept {
  Detection mark;
  if (!options_.rings || !seed_ring(view.window, chord, v, options_.ring_ratio_q16, limits_, mark.outer)) return;
  mark.outer = view.in_image(mark.outer);
  if (is_known(mark, found)) return;
  if (measure_ring(view.image, mark.outer, options_.ring_ratio_q16, camera_of(view.image), limits_.budget, mark))
    keep(mark, found);
}

void Detector::inspect_dot(const View& view, int first, int end, int v, bool light, Detections& found) noexcept {
  Detection mark;
  if (!seed_dot(view.window, first, end, v, light, limits_, mark.outer)) return;
  mark.kind = light ? MarkKind::dot_light_on_dark : MarkKind::dot_dark_on_light;
  mark.outer = view.in_image(mark.outer);
  if (is_known(mark, found)) return;
  if (measure_dot(view.image, mark.outer, light, limits_.budget, mark)) keep(mark, found);
}

// A ring found twice, a dot found twice, or a dot that is a ring's hole.
bool Detector::is_known(const Detection& mark, const Detections& found) const noexcept {
  return std::any_of(found.begin(), found.end(), [&mark](const Detection& other) {
    return (other.kind == mark.kind || other.kind == MarkKind::ring) && same_place(mark, other);
  });
}

// The fit may have moved a new seed onto a mark that is known.
void Detector::keep(const Detection& mark, Detections& found) noexcept {
  if (is_known(mark, found)) return;
  const auto in_ring = [&mark](const Detection& other) {
    return mark.kind == MarkKind::ring && same_place(other, mark);
  };
  Detection* const hole = std::find_if(found.begin(), found.end(), in_ring);
  if (hole != found.end())
    *hole = mark;
  else if (!found.push_back(mark))
    overloaded_ = true;
}

}  // namespace articam::vision
