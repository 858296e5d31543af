#include "core/vision/seed.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/vision/fixed_point.hpp"

namespace articam::vision {
namespace {

struct Step {
  int du, dv;
  constexpr Step operator-() const noexcept { return {-du, -dv}; }
};
constexpr Step kAlong{1, 0}, kDown{0, 1}, kFall{1, 1}, kRise{1, -1};

// Where a line through a mark meets an edge: steps from a pixel inside, Q8, backwards and ahead.
struct Chord {
  int back_q8{}, ahead_q8{};
  int length_q8() const noexcept { return back_q8 + ahead_q8; }
  int middle_q8() const noexcept { return (ahead_q8 - back_q8) / 2; }
};

// What blur, noise and the grid may take from a chord's ends.
constexpr int kSlack_px = 4, kSlack_q8 = 3 * 128;

class Walker {
 public:
  Walker(const ImageView& image, int threshold, SearchLimits& limits) noexcept
      : image_{image}, threshold_{threshold}, limits_{limits} {}

  bool light(int u, int v) const noexcept { return image_.row(v)[u] >= threshold_; }

  /// Two steps beyond both ends the grey level has passed the threshold by `margin`; what wavers about it is noise. Of
  /// a small mark they may lie beyond its card.
  bool is_clear_beyond(int u, int v, Step step, const Chord& chord, bool light, int margin) const noexcept {
    const auto passed = [&](int n) {
      const int u_px = std::clamp(u + n * step.du, 0, image_.width_px - 1);
      const int grey = image_.row(std::clamp(v + n * step.dv, 0, image_.height_px - 1))[u_px];
      return light ? grey < threshold_ - margin : grey >= threshold_ + margin;
    };
    if (chord.length_q8() < 12 * 256) return true;
    return passed((chord.ahead_q8 >> 8) + 2) && passed(-(chord.back_q8 >> 8) - 2);
  }

  /// The edges of the run of one colour that begins `gap` steps from (u, v) and goes to both sides, at most `most`
  /// steps and about as far ahead as back. False where it does not end there, or at the image's border.
  bool cross(int u, int v, Step step, bool light, const Chord& gap, int most, Chord& out) const noexcept {
    const int skip_ahead = (gap.ahead_q8 + 255) >> 8, skip_back = (gap.back_q8 + 255) >> 8;
    const int ahead = run(u + skip_ahead * step.du, v + skip_ahead * step.dv, step, light, most);
    if (ahead < 0) return false;
    const int alike = std::min(most, ahead + (skip_ahead + ahead) / 4 + kSlack_px);
    const int back = run(u - skip_back * step.du, v - skip_back * step.dv, -step, light, alike);
    if (back < 0) return false;
    out = {fine_q8(u, v, -step, skip_back + back), fine_q8(u, v, step, skip_ahead + ahead)};
    return true;
  }

 private:
  // Steps from (u, v) until the colour changes, at most `most`; -1 where it does not.
  int run(int u, int v, Step step, bool light, int most) const noexcept {
    const int room_u = step.du > 0 ? image_.width_px - 1 - u : (step.du < 0 ? u : most);
    const int room_v = step.dv > 0 ? image_.height_px - 1 - v : (step.dv < 0 ? v : most);
    const int room = std::min({room_u, room_v, most});
    const std::ptrdiff_t stride = step.dv * image_.stride_bytes + step.du;
    const std::uint8_t* pixel = image_.row(v) + u;
    for (int n = 1; n <= room; ++n) {
      pixel += stride;
      if ((*pixel >= threshold_) != light) {
        limits_.budget -= n;
        return n;
      }
    }
    limits_.budget -= std::max(room, 0);
    return -1;
  }

  // Where between the steps n - 1 and n from (u, v) the grey level passes the threshold.
  int fine_q8(int u, int v, Step step, int n) const noexcept {
    const int before = image_.row(v + (n - 1) * step.dv)[u + (n - 1) * step.du];
    const int after = image_.row(v + n * step.dv)[u + n * step.du];
    return ((n - 1) << 8) + ((2 * threshold_ - 1 - 2 * before) << 8) / (2 * (after - before));
  }

  const ImageView& image_;
  int threshold_;
  SearchLimits& limits_;
};

bool matches_ratio(const Chord& hole, const Chord& whole, int ratio_q8) noexcept {
  const int expected_q8 = whole.length_q8() * ratio_q8 >> 8;
  const int off_q8 = std::abs(hole.middle_q8() - whole.middle_q8());
  return 5 * hole.length_q8() + 3 * kSlack_q8 > 3 * expected_q8 &&
         3 * hole.length_q8() < 4 * expected_q8 + 2 * kSlack_q8 && 8 * off_q8 < whole.length_q8() + kSlack_q8;
}

// 2^62 / q to a root, Q16, where q is Q(34 - shift) of 1 / px^2.
std::int64_t inverse_root_q16(std::int64_t q, int shift) noexcept {
  const std::int64_t inverse = (std::int64_t{1} << 62) / q;
  return integer_sqrt(shift <= 4 ? inverse << (4 - shift) : inverse >> (shift - 4));
}

// Half chords h of an ellipse are 1 / h^2 = Q(direction), a quadratic form: Q(1,1) + Q(1,-1) = 2 Q(1,0) + 2 Q(0,1)
// tells whether it is one, or what a hidden chord's would be; that has no length. M M^T = Q^-1.
bool span(int u, int v, const std::array<Chord, 4>& chords, Ellipse& out) noexcept {
  const auto& [along, down, fall, rise] = chords;
  const auto form_q34 = [](const Chord& c) {
    return c.length_q8() == 0 ? 0 : (std::int64_t{1} << 52) / square(std::max(c.length_q8(), 256));  // at least a pixel
  };
  std::int64_t q00 = form_q34(along), q11 = form_q34(down), qf = form_q34(fall), qr = form_q34(rise);
  const std::int64_t expected = 2 * (q00 + q11);
  if (std::min({q00, q11, qf, qr}) > 0) {
    const int least_q8 = std::min({along.length_q8(), down.length_q8(), fall.length_q8(), rise.length_q8()});
    if (std::abs(qf + qr - expected) > expected / 6 + expected * 256 / std::max(least_q8, 256)) return false;
  } else {
    std::int64_t& hidden = q00 == 0 ? q00 : (q11 == 0 ? q11 : (qf == 0 ? qf : qr));
    const std::int64_t missing = &hidden == &q00 || &hidden == &q11 ? (qf + qr - expected) / 2 : expected - qf - qr;
    if (missing <= 0) return false;
    hidden = missing;
  }
  const int shift = std::max(0, 34 - std::countl_zero(static_cast<std::uint64_t>(std::max(q00, q11))));
  const std::int64_t a = q00 >> shift, b = q11 >> shift, c = (qf - qr) / 4 >> shift;  // below 2^30: products fit
  if (b == 0 || a * b - c * c <= a * b / 16) return false;                            // flatter than any mark
  const std::int64_t m00 = inverse_root_q16(a - c * c / b, shift), m11 = inverse_root_q16(b, shift);
  const std::int64_t m10 = -c * m00 / b;
  out = {((u << 8) + along.middle_q8()) * 256, ((v << 8) + down.middle_q8()) * 256, static_cast<std::int32_t>(m00),
         static_cast<std::int32_t>(m10), static_cast<std::int32_t>(m11)};
  return true;
}

constexpr int rounded(int q8) noexcept { return (q8 + 128) >> 8; }
constexpr int kFlattest = 5;       // longest : shortest chord
constexpr int kCostOfLooking = 8;  // at a row's chord, before the first pixel is walked
constexpr std::array<Step, 4> kSteps{kAlong, kDown, kFall, kRise};

// From a row's pixel (u, v) down to the middle of its colour's run, and then along. False where another row is nearer
// to the middle.
bool to_the_middle(const Walker& walk, bool light, int most, int& u, int& v) noexcept {
  Chord chord;
  if (walk.light(u, v) != light || !walk.cross(u, v, kDown, light, {}, most, chord)) return false;
  // Every second row is searched. Of large holes several may try: in weak light noise ends a long chord too soon.
  constexpr int kHalfPitch_q8 = 5 * 64, kLarge_q8 = 24 * 256;
  const int most_q8 = kHalfPitch_q8 + std::max(0, chord.length_q8() - kLarge_q8) / 4;
  if (std::abs(chord.middle_q8()) > most_q8) return false;
  v += rounded(chord.middle_q8());
  if (walk.light(u, v) != light || !walk.cross(u, v, kAlong, light, {}, most, chord)) return false;
  u += rounded(chord.middle_q8());
  return walk.light(u, v) == light;
}

// Both edges on a line through a ring's middle.
bool cross_ring(const Walker& walk, const RowChord& row, int u, int v, Step step, std::int32_t ratio_q8, Chord& hole,
                Chord& whole) noexcept {
  const int most_hole = kFlattest * (row.inner_end - row.inner_first) + kSlack_px;
  return walk.cross(u, v, step, true, {}, most_hole, hole) &&
         walk.cross(u, v, step, false, hole, kFlattest * (row.end - row.first), whole) &&
         matches_ratio(hole, whole, ratio_q8);
}

}  // namespace

bool seed_ring(const ImageView& image, const RowChord& row, int v, std::int32_t ratio_q16, SearchLimits& limits,
               Ellipse& outer) noexcept {
  const std::uint8_t* grey = image.row(v);
  const std::int32_t ratio_q8 = ratio_q16 >> 8;
  int u = (row.inner_first + row.inner_end - 1) / 2;
  const int dark = (grey[(row.first + row.inner_first) / 2] + grey[(row.inner_end + row.end - 1) / 2]) / 2;
  const int light = (grey[u] + grey[(row.inner_first + row.inner_end) / 2] + 1) / 2;
  limits.budget -= kCostOfLooking;
  if (light - dark < limits.least_contrast) return false;
  const Walker walk{image, (light + dark + 1) / 2, limits};
  const int most_hole = kFlattest * (row.inner_end - row.inner_first) + kSlack_px;
  if (!to_the_middle(walk, true, most_hole, u, v)) return false;

  // Motion along a chord may hide its ends. But three chords of a small mark, or of noise, are any three.
  const int may_hide = row.end - row.first >= 12 && light - dark >= 4 * limits.least_contrast ? 1 : 0;
  std::array<Chord, 4> chords;
  int holes_q8 = 0, wholes_q8 = 0, hidden = 0;
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    Chord hole;
    if (!cross_ring(walk, row, u, v, kSteps[i], ratio_q8, hole, chords[i])) {
      if (++hidden > may_hide) return false;
      hole = chords[i] = {};
    }
    holes_q8 += hole.length_q8(), wholes_q8 += chords[i].length_q8();
  }
  // All chords together: a third of the ratio, and half a pixel of each end.
  const int expected_q8 = wholes_q8 * ratio_q8 >> 8;
  return 3 * std::abs(holes_q8 - expected_q8) < expected_q8 + 3 * 4 * 256 && span(u, v, chords, outer);
}

bool seed_dot(const ImageView& image, int first, int end, int v, bool light, SearchLimits& limits,
              Ellipse& edge) noexcept {
  constexpr int kLeast_px = 3;
  limits.budget -= kCostOfLooking / 4;
  if (end - first < kLeast_px || first < 2 || end + 1 >= image.width_px) return false;
  const std::uint8_t* grey = image.row(v);
  int u = (first + end - 1) / 2;
  const int inside = (grey[u] + grey[(first + end) / 2]) / 2, outside = (grey[first - 2] + grey[end + 1]) / 2;
  if ((light ? inside - outside : outside - inside) < limits.least_contrast) return false;
  const Walker walk{image, (inside + outside + 1) / 2, limits};
  const int most = kFlattest * (end - first) + kSlack_px;
  if (!to_the_middle(walk, light, most, u, v)) return false;
  std::array<Chord, 4> chords;
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    if (!walk.cross(u, v, kSteps[i], light, {}, most, chords[i])) return false;
    if (8 * std::abs(chords[i].middle_q8()) > chords[i].length_q8() + kSlack_q8) return false;
    if (!walk.is_clear_beyond(u, v, kSteps[i], chords[i], light, limits.least_contrast / 3)) return false;
  }
  return span(u, v, chords, edge);
}

}  // namespace articam::vision
