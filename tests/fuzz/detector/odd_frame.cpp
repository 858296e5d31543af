#include "tests/fuzz/detector/odd_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/config.hpp"

namespace articam::fuzz {
namespace {

enum class Ground { flat, gradient, checker, noise, bytes };

void paint_ground(FuzzedDataProvider& bytes, OddFrame& frame) {
  const auto kind = static_cast<Ground>(bytes.ConsumeIntegralInRange(0, 4));
  const int first = bytes.ConsumeIntegral<std::uint8_t>(), second = bytes.ConsumeIntegral<std::uint8_t>();
  const int size_px = bytes.ConsumeIntegralInRange(1, 16);
  const auto texture = kind == Ground::bytes ? bytes.ConsumeBytes<std::uint8_t>(64) : std::vector<std::uint8_t>{};
  std::minstd_rand random(static_cast<unsigned>(1 + first + 256 * second));
  for (int v = 0; v < frame.height_px(); ++v) {
    for (int u = 0; u < frame.width_px(); ++u) {
      int grey = first;
      if (kind == Ground::gradient) grey += (second - first) * u / frame.width_px();
      if (kind == Ground::checker && ((u / size_px + v / size_px) & 1) != 0) grey = second;
      if (kind == Ground::noise)
        grey = std::min(first, second) + static_cast<int>(random() >> 8) % (std::abs(second - first) + 1);
      if (!texture.empty()) grey = texture[static_cast<std::size_t>(u / size_px + 7 * (v / size_px)) % texture.size()];
      frame.at(u, v) = static_cast<std::uint8_t>(grey);
    }
  }
}

struct Disc {
  double u_px, v_px, radius_px, flatness, turn_rad, softness_px;
};

void paint(const Disc& disc, int grey, OddFrame& frame) {
  const double c = std::cos(disc.turn_rad), s = std::sin(disc.turn_rad), reach = disc.radius_px + disc.softness_px;
  const int u_end = std::min(frame.width_px() - 1, static_cast<int>(disc.u_px + reach) + 1);
  const int v_end = std::min(frame.height_px() - 1, static_cast<int>(disc.v_px + reach) + 1);
  for (int v = std::max(0, static_cast<int>(disc.v_px - reach)); v <= v_end; ++v) {
    for (int u = std::max(0, static_cast<int>(disc.u_px - reach)); u <= u_end; ++u) {
      const double du = u - disc.u_px, dv = v - disc.v_px;
      const double within_px = disc.radius_px - std::hypot(c * du + s * dv, (c * dv - s * du) / disc.flatness);
      const double share = std::clamp(within_px / disc.softness_px + 0.5, 0.0, 1.0);
      std::uint8_t& pixel = frame.at(u, v);
      pixel = static_cast<std::uint8_t>(std::lround(pixel + share * (grey - pixel)));
    }
  }
}

void paint_mark(FuzzedDataProvider& bytes, OddFrame& frame) {
  const auto share = [&bytes] { return bytes.ConsumeIntegral<std::uint8_t>() / 255.0; };
  Disc disc{share() * frame.width_px(),
            share() * frame.height_px(),
            3 + 40 * share() * share(),
            0.2 + 0.8 * share(),
            3.15 * share(),
            0.5 + 4 * share()};
  const int mark = bytes.ConsumeIntegral<std::uint8_t>(), card = bytes.ConsumeIntegral<std::uint8_t>();
  Disc around = disc, hole = disc;
  around.radius_px *= 1.4;
  hole.radius_px *= 0.15 + 0.7 * share();
  paint(around, card, frame);
  paint(disc, mark, frame);
  if (bytes.ConsumeBool()) paint(hole, card, frame);
}

void paint_damage(FuzzedDataProvider& bytes, OddFrame& frame) {
  const int u = bytes.ConsumeIntegralInRange(0, frame.width_px() - 1);
  const int v = bytes.ConsumeIntegralInRange(0, frame.height_px() - 1);
  const int u_end = std::min(frame.width_px(), u + bytes.ConsumeIntegralInRange(1, 32));
  const int v_end = std::min(frame.height_px(), v + bytes.ConsumeIntegralInRange(1, 32));
  const auto grey = bytes.ConsumeIntegral<std::uint8_t>();
  for (int j = v; j < v_end; ++j) {
    for (int i = u; i < u_end; ++i) frame.at(i, j) = grey;
  }
}

}  // namespace

OddFrame::OddFrame(int width_px, int height_px, int stride_bytes, std::uint8_t padding)
    : width_px_{width_px}, height_px_{height_px}, stride_bytes_{stride_bytes} {
  const std::size_t size = offset(width_px, height_px - 1);
  pixels_ = std::make_unique<std::uint8_t[]>(size);
  std::fill_n(pixels_.get(), size, padding);
}

OddFrame OddFrame::with_padding(std::uint8_t padding) const {
  OddFrame other{width_px_, height_px_, stride_bytes_, padding};
  for (int v = 0; v < height_px_; ++v) std::copy_n(&pixels_[offset(0, v)], width_px_, &other.pixels_[offset(0, v)]);
  return other;
}

OddFrame odd_frame(FuzzedDataProvider& bytes) {
  // Strips as long as the largest frame, and small frames of any shape: a whole large frame costs too many
  // milliseconds.
  const int shape = bytes.ConsumeIntegralInRange(0, 15);
  const int width = bytes.ConsumeIntegralInRange(1, shape == 0 ? kMaxImageWidth_px : 112);
  const int height = bytes.ConsumeIntegralInRange(1, shape == 1 ? kMaxImageHeight_px : (shape == 0 ? 24 : 88));
  const int stride = width + bytes.ConsumeIntegralInRange(0, 70);
  OddFrame frame{shape == 1 ? std::min(width, 24) : width, height, stride, 0};
  paint_ground(bytes, frame);
  for (int n = bytes.ConsumeIntegralInRange(0, 6); n > 0; --n) paint_mark(bytes, frame);
  for (int n = bytes.ConsumeIntegralInRange(0, 4); n > 0; --n) paint_damage(bytes, frame);
  return frame;
}

}  // namespace articam::fuzz
