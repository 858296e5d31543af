#include "host_sim/world/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/so3.hpp"
#include "core/tracker/rolling_shutter.hpp"
#include "host_sim/world/clutter.hpp"
#include "host_sim/world/pixel_bounds.hpp"

namespace articam::sim {
namespace {

constexpr double kLight_grey = 215, kDark_grey = 30, kWall_grey = 130;
constexpr double kCardRatio = 1.4;  // a card's diameter by its marker's
constexpr double kNearest_m = 0.01;
constexpr int kLightBits = 14;
constexpr double kInstantsPerPixel = 2;
constexpr int kMostInstants = 64;

constexpr int rounded(double x) { return static_cast<int>(x + (x < 0 ? -0.5 : 0.5)); }

/// Where the marker is after a time.
ImagedDisc disc_at(const SceneMarker& marker, double radius_m, double t_s) noexcept {
  return {marker.centre_cam_m + t_s * marker.velocity,
          math::exp_so3<double>(t_s * marker.angular_velocity) * marker.normal_cam, radius_m};
}

PixelBox whole(const GreyPlane& plane) { return {0, 0, plane.width_px - 1, plane.height_px - 1}; }

/// The box and `reach` more on every side, within the plane.
PixelBox grown(const PixelBox& box, int reach, const GreyPlane& plane) {
  return {std::max(box.u_min_px - reach, 0), std::max(box.v_min_px - reach, 0),
          std::min(box.u_max_px + reach, plane.width_px - 1), std::min(box.v_max_px + reach, plane.height_px - 1)};
}

GreyPlane still_background(const CameraParameters& camera, const RenderOptions& options) {
  GreyPlane plane{camera.width_px, camera.height_px, grey_q6(kWall_grey)};
  if (options.clutter) paint_clutter(options.seed, plane);
  return plane;
}

}  // namespace

Renderer::Renderer(const CameraParameters& camera, const RenderOptions& options)
    : camera_{camera},
      exposure_time_s_{options.exposure_time_s},
      light_gradient_{std::max(options.light_gradient, 1.0)},
      light_q14_(static_cast<std::size_t>(camera.width_px)),
      covered_(static_cast<std::size_t>(camera.width_px)),
      blur_{options.blur_px},
      noise_{options.noise_grey, options.seed},
      background_{still_background(camera, options)},
      soft_background_{background_},
      lit_background_{background_},
      sharp_{background_},
      soft_{background_} {
  for (int row = 0; row <= camera.height_px; ++row) {
    for (int column = 0; column <= camera.width_px; ++column) {
      const auto ray = camera_.unproject({column - 0.5, row - 0.5});
      // Beyond the fold of the lens model there is no ray: nothing is seen there.
      constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
      corner_rays_.push_back(ray.ok() ? ray.value() : Vec<double, 2>{kNone, kNone});
      if (column == 0 || row == 0) continue;
      const auto step = (corner_ray(column, row) - corner_ray(column - 1, row - 1)).cwiseAbs().maxCoeff();
      largest_step_ = std::max(largest_step_, step);  // a NaN is never the larger
    }
  }
  blur_.apply(background_, whole(background_), soft_background_);
  set_exposure(options.exposure);
}

void Renderer::set_exposure(double exposure) {
  if (exposure == exposure_) return;
  exposure_ = exposure;
  const int width = camera_.parameters().width_px;
  for (int u = 0; u < width; ++u) {
    const double across = static_cast<double>(u) / width;
    light_q14_[static_cast<std::size_t>(u)] =
        rounded(exposure * (1 + across * (1 / light_gradient_ - 1)) * (1 << kLightBits));
  }
  soft_ = soft_background_;
  light(whole(soft_));
  lit_background_ = soft_;
}

void Renderer::render(std::span<const SceneMarker> markers, std::uint64_t frame_index,
                      std::vector<std::uint8_t>& pixels, std::span<const Limb> limbs) {
  sharp_ = background_;
  soft_ = lit_background_;
  std::vector<PixelBox> touched;
  for (const SceneMarker& marker : markers) touched.push_back(paint_marker(marker));
  for (const Limb& limb : limbs) touched.push_back(paint_limb(limb));
  for (const PixelBox& box : touched) {
    if (box.empty()) continue;
    const PixelBox softened = grown(box, blur_.reach_px(), soft_);
    blur_.apply(sharp_, softened, soft_);
    light(softened);
  }
  noise_.digitise(soft_, frame_index, pixels);
}

Vec<double, 3> Renderer::corner_ray(int column, int row) const noexcept {
  const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(camera_.parameters().width_px + 1);
  return corner_rays_[index + static_cast<std::size_t>(column)].homogeneous();
}

Renderer::Passage Renderer::passage(const SceneMarker& marker) const noexcept {
  const double rate_mps = marker.velocity.norm() + marker.outer_radius_m * marker.angular_velocity.norm();
  const double way_px =
      exposure_time_s_ * rate_mps / std::max(marker.centre_cam_m.z(), kNearest_m) * camera_.focal_px();
  const int instants = 1 + static_cast<int>(std::min(kInstantsPerPixel * way_px, kMostInstants - 1.0));
  const double half_s = instants > 1 ? 0.5 * exposure_time_s_ : 0;
  return {instants, -half_s, camera_.parameters().readout_time_s + half_s};
}

/// Pixels that a disc about the marker's centre may touch on its way.
PixelBox Renderer::image_box(const SceneMarker& marker, double radius_m) const noexcept {
  constexpr int kSides = 16;
  constexpr double kAround = 1.0196;  // 1 / cos(pi / 16): a polygon around the circle, not in it
  const Passage way = passage(marker);
  PixelBounds bounds;
  for (const double t_s : {way.from_s, way.to_s}) {
    const Vec<double, 3> normal = math::exp_so3<double>(t_s * marker.angular_velocity) * marker.normal_cam;
    const Vec<double, 3> e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
    for (int i = 0; i < kSides; ++i) {
      const auto turn = math::sin_cos(2 * 3.14159265358979323846 / kSides * i);
      const Vec<double, 3> p =
          marker.centre_cam_m + t_s * marker.velocity + kAround * radius_m * (turn.cos * e1 + turn.sin * e2);
      if (!(p.z() > kNearest_m)) return {};
      bounds.add(camera_.project(p.hnormalized()));
    }
  }
  return bounds.within(camera_.parameters());
}

/// Calls paint(grey level, share of the pixel covered) for every pixel that the disc touches.
template <class Paint>
void Renderer::paint_disc(const SceneMarker& marker, double radius_m, const Paint& paint) {
  const PixelBox box = image_box(marker, radius_m);
  if (box.empty()) return;
  const int instants = passage(marker).instants;
  for (int v = box.v_min_px; v <= box.v_max_px; ++v) {
    std::fill(covered_.begin() + box.u_min_px, covered_.begin() + box.u_max_px + 1, 0.0);
    const double row_s = tracker::row_delay_s<double>(camera_.parameters(), v);
    for (int i = 0; i < instants; ++i) {
      const double t_s = row_s + ((i + 0.5) / instants - 0.5) * exposure_time_s_;
      cover(disc_at(marker, radius_m, t_s), v, box.u_min_px, box.u_max_px);
    }
    for (int u = box.u_min_px; u <= box.u_max_px; ++u) {
      const double share = covered_[static_cast<std::size_t>(u)] / instants;
      if (share > 0) paint(sharp_.row(v)[u], share);
    }
  }
}

/// Adds the shares of a row's pixels that the disc covers.
void Renderer::cover(const ImagedDisc& disc, int v, int u_min, int u_max) noexcept {
  const double bend = disc.bend(largest_step_);
  const auto side = [&](int column, int row) {
    const double value = disc.side(corner_ray(column, row));
    return value == value ? value : std::numeric_limits<double>::infinity();
  };
  double upper_left = side(u_min, v), lower_left = side(u_min, v + 1);
  for (int u = u_min; u <= u_max; ++u) {
    const double upper_right = side(u + 1, v), lower_right = side(u + 1, v + 1);
    const auto [nearest, farthest] = std::minmax({upper_left, upper_right, lower_left, lower_right});
    double& covered = covered_[static_cast<std::size_t>(u)];
    if (farthest < -bend) {
      covered += 1;
    } else if (nearest <= bend) {
      covered +=
          disc.coverage({corner_ray(u, v), corner_ray(u + 1, v), corner_ray(u, v + 1), corner_ray(u + 1, v + 1)});
    }
    upper_left = upper_right;
    lower_left = lower_right;
  }
}

/// The card, then the mark, then a ring's light inside. Returns the pixels that may have changed.
PixelBox Renderer::paint_marker(const SceneMarker& marker) {
  const bool seen_from_behind = !(marker.normal_cam.dot(marker.centre_cam_m) < 0);
  if (marker.kind == model::MarkerKind::point || seen_from_behind) return {};
  const double card_radius_m = kCardRatio * marker.outer_radius_m;
  const PixelBox touched = image_box(marker, card_radius_m);
  if (touched.empty()) return {};

  const bool light_mark = marker.kind == model::MarkerKind::dot_light_on_dark;
  const int card = grey_q6(light_mark ? kDark_grey : kLight_grey);
  const int mark_minus_card = grey_q6(light_mark ? kLight_grey : kDark_grey) - card;
  // The card replaces what lies under it. The mark is inside its card, and the hole inside its mark, so there the
  // differences add up without error even in a pixel that two edges cross.
  const auto add = [](int difference) {
    return [difference](std::int16_t& grey, double share) {
      grey = static_cast<std::int16_t>(grey + rounded(share * difference));
    };
  };
  paint_disc(marker, card_radius_m, [card](std::int16_t& grey, double share) {
    grey = static_cast<std::int16_t>(grey + rounded(share * (card - grey)));
  });
  paint_disc(marker, marker.outer_radius_m, add(mark_minus_card));
  if (marker.kind == model::MarkerKind::ring) paint_disc(marker, marker.inner_radius_m, add(-mark_minus_card));
  return touched;
}

PixelBox Renderer::paint_limb(const Limb& limb) {
  const PixelBox box = sim::image_box(limb, camera_);
  for (int v = box.v_min_px; v <= box.v_max_px; ++v) {
    for (int u = box.u_min_px; u <= box.u_max_px; ++u) {
      const Vec<double, 3> ray = 0.5 * (corner_ray(u, v) + corner_ray(u + 1, v + 1));
      sim::paint_limb(limb, ray, camera_.focal_px(), sharp_.row(v)[u]);
    }
  }
  return box;
}

void Renderer::light(const PixelBox& box) {
  for (int v = box.v_min_px; v <= box.v_max_px; ++v) {
    std::int16_t* row = soft_.row(v);
    for (int u = box.u_min_px; u <= box.u_max_px; ++u) {
      row[u] = static_cast<std::int16_t>((row[u] * light_q14_[static_cast<std::size_t>(u)]) >> kLightBits);
    }
  }
}

}  // namespace articam::sim
