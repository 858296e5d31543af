#include "tests/bits/scene.hpp"

#include <algorithm>

#include "core/math/so3.hpp"
#include "core/model/configuration.hpp"
#include "core/model/forward_kinematics.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"

namespace articam::test {
namespace {

using Model = models::PrinterDrawer;
using V3 = Vec<double, 3>;

constexpr int kLight_grey = 205, kDark_grey = 40;
constexpr double kFocal_px = 525;

/// A triangle wave between 0 and 1 that starts at 0.
constexpr double swing(std::uint32_t k, std::uint32_t period) noexcept {
  const std::uint32_t phase = k % period;
  return 2.0 * (phase * 2 < period ? phase : period - phase) / period;
}

model::Configuration<Model, double> configuration(std::uint32_t k) noexcept {
  constexpr double kDeg = 0.017453292519943295;
  model::Configuration<Model, double> q;
  q.T_cam_obj.t = {0.02 + 0.02 * swing(k, 120), 0.08 - 0.01 * swing(k, 70), 0.70 - 0.05 * swing(k, 200)};
  q.T_cam_obj.R = math::exp_so3<double>({0, 0, 5 * kDeg}) *
                  math::exp_so3<double>({0, (4 * swing(k, 90) - 10) * kDeg, 0}) *
                  math::exp_so3<double>({30 * kDeg, 0, 0});
  q.joints = {0.02 + 0.1 * swing(k, 160), 0.12};
  return q;
}

constexpr bool hidden(std::uint32_t k, std::size_t i_marker) noexcept {
  return (k >= 60 && k < 64) || (k >= 100 && k < 110 && i_marker == 4);
}

/// A circle's image as xx x^2 + xy x y + yy y^2 + x x + y y + one < 0; x and y in eighths of a pixel from an origin.
struct Conic {
  std::int64_t xx{}, xy{}, yy{}, x{}, y{}, one{};

  bool contains(std::int64_t at_x, std::int64_t at_y) const noexcept {
    return xx * at_x * at_x + xy * at_x * at_y + yy * at_y * at_y + x * at_x + y * at_y + one < 0;
  }
  /// How many of the pixel's 4 x 4 samples lie inside.
  int samples_inside(int u, int v) const noexcept {
    int inside = 0;
    for (int dy = -3; dy <= 3; dy += 2) {
      for (int dx = -3; dx <= 3; dx += 2) inside += contains(8 * u + dx, 8 * v + dy) ? 1 : 0;
    }
    return inside;
  }
};

/// The ray d meets the circle's plane at distance r from its centre c where
///   d' M d = 0,  M = (n'c)^2 I - (n'c)(n c' + c n') + (c'c - r^2) n n';  inside it is negative.
Conic conic_of(const V3& c, const V3& n, double radius_m, const V3& origin_ray) noexcept {
  const double nc = n.dot(c);
  Mat<double, 3, 3> M = nc * nc * Mat<double, 3, 3>::Identity();
  M -= nc * (n * c.transpose() + c * n.transpose());
  M += (c.dot(c) - radius_m * radius_m) * (n * n.transpose());
  const V3 right{1 / (8 * kFocal_px), 0, 0}, down{0, 1 / (8 * kFocal_px), 0};
  const double one = origin_ray.dot(M * origin_ray);
  const double scale = 0x1p40 / (one < 0 ? -one : one);
  const auto rounded = [scale](double x) { return static_cast<std::int64_t>(x * scale + (x < 0 ? -0.5 : 0.5)); };
  return {rounded(right.dot(M * right)),          rounded(2 * right.dot(M * down)),      rounded(down.dot(M * down)),
          rounded(2 * origin_ray.dot(M * right)), rounded(2 * origin_ray.dot(M * down)), rounded(one)};
}

void draw_ring(const V3& c, const V3& n, const model::MarkerRow& row, std::span<std::uint8_t> pixels) noexcept {
  const CameraParameters camera = Scene::camera();
  const int u0 = static_cast<int>(camera.cx_px + kFocal_px * c.x() / c.z());
  const int v0 = static_cast<int>(camera.cy_px + kFocal_px * c.y() / c.z());
  const V3 ray{(u0 - camera.cx_px) / kFocal_px, (v0 - camera.cy_px) / kFocal_px, 1};
  const Conic outer = conic_of(c, n, row.outer_diameter_m / 2, ray),
              inner = conic_of(c, n, row.inner_diameter_m / 2, ray);
  const int reach = static_cast<int>(0.6 * kFocal_px * row.outer_diameter_m / c.z()) + 2;
  for (int v = std::max(v0 - reach, 0); v <= std::min(v0 + reach, Scene::kHeight_px - 1); ++v) {
    for (int u = std::max(u0 - reach, 0); u <= std::min(u0 + reach, Scene::kWidth_px - 1); ++u) {
      const int dark = outer.samples_inside(u - u0, v - v0) - inner.samples_inside(u - u0, v - v0);
      std::uint8_t& pixel = pixels[static_cast<std::size_t>(v * Scene::kWidth_px + u)];
      pixel = static_cast<std::uint8_t>(pixel + (kDark_grey - kLight_grey) * dark / 16);
    }
  }
}

}  // namespace

CameraParameters Scene::camera() noexcept {
  CameraParameters camera;
  camera.width_px = kWidth_px, camera.height_px = kHeight_px;
  camera.fx_px = camera.fy_px = kFocal_px;
  camera.cx_px = 319.5, camera.cy_px = 239.5;
  return camera;
}

ImageView Scene::draw(std::uint32_t k, std::span<std::uint8_t, kPixels> pixels) noexcept {
  // Light that falls to the right and down by 35 grey levels, noise of -4 .. 3 (xorshift32, Marsaglia 2003).
  std::uint32_t random = 0x9E3779B9U * (k + 1);
  for (int v = 0; v < kHeight_px; ++v) {
    for (int u = 0; u < kWidth_px; ++u) {
      random ^= random << 13;
      random ^= random >> 17;
      random ^= random << 5;
      const int noise = static_cast<int>(random >> 29) - 4;
      pixels[static_cast<std::size_t>(v * kWidth_px + u)] =
          static_cast<std::uint8_t>(kLight_grey + 35 + noise - (u + v) / 32);
    }
  }
  const auto q = configuration(k);
  const auto kinematics = model::forward_kinematics<Model, double>(q.joints);
  for (std::size_t i = 0; i < Model::kMarkers.size(); ++i) {
    if (hidden(k, i)) continue;
    draw_ring(q.T_cam_obj * kinematics.markers[i].centre, q.T_cam_obj.R * kinematics.markers[i].normal,
              Model::kMarkers[i], pixels);
  }
  return {pixels.data(), kWidth_px, kHeight_px, kWidth_px};
}

}  // namespace articam::test
