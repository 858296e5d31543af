#include "host_sim/world/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/trigonometry.hpp"
#include "host_sim/world/clutter.hpp"
#include "host_sim/world/hash.hpp"
#include "host_sim/world/imaged_disc.hpp"

namespace articam::sim {
namespace {

constexpr double kLight_grey = 215, kDark_grey = 30, kWall_grey = 130;
constexpr double kCardRatio = 1.4;  // a card's diameter by its marker's
constexpr double kNearest_m = 0.01;
constexpr int kLightBits = 14;

constexpr int rounded(double x) { return static_cast<int>(x + (x < 0 ? -0.5 : 0.5)); }

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
      motion_{{options.motion_px[0], options.motion_px[1]}},
      blur_{options.blur_px},
      noise_{options.noise_grey, options.seed},
      background_{still_background(camera, options)},
      moved_background_{background_},
      soft_background_{background_},
      sharp_{background_},
      moved_{background_},
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
  const double darkest = 1 / std::max(options.light_gradient, 1.0);
  for (int u = 0; u < camera.width_px; ++u) {
    const double across = static_cast<double>(u) / camera.width_px;
    light_q14_.push_back(rounded(options.exposure * (1 + across * (darkest - 1)) * (1 << kLightBits)));
  }
  if (!motion_.still()) motion_.apply(background_, whole(background_), moved_background_);
  blur_.apply(moved_background_, whole(soft_), soft_);
  light(whole(soft_));
  soft_background_ = soft_;
}

void Renderer::render(std::span<const SceneMarker> markers, std::uint64_t frame_index,
                      std::vector<std::uint8_t>& pixels) {
  sharp_ = background_;
  soft_ = soft_background_;
  if (!motion_.still()) moved_ = moved_background_;
  std::vector<PixelBox> touched;
  for (const SceneMarker& marker : markers) touched.push_back(paint_marker(marker));
  for (PixelBox& box : touched) {
    if (!box.empty()) box = move(box);
  }
  for (const PixelBox& box : touched) {
    if (box.empty()) continue;
    const PixelBox softened = grown(box, blur_.reach_px(), soft_);
    blur_.apply(motion_.still() ? sharp_ : moved_, softened, soft_);
    light(softened);
  }
  noise_.digitise(soft_, frame_index, pixels);
}

Vec<double, 3> Renderer::corner_ray(int column, int row) const noexcept {
  const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(camera_.parameters().width_px + 1);
  return corner_rays_[index + static_cast<std::size_t>(column)].homogeneous();
}

/// Pixels that a disc about the marker's centre may touch.
PixelBox Renderer::image_box(const SceneMarker& marker, double radius_m) const noexcept {
  constexpr int kSides = 16;
  constexpr double kAround = 1.0196;  // 1 / cos(pi / 16): a polygon around the circle, not in it
  const Vec<double, 3> e1 = marker.normal_cam.unitOrthogonal(), e2 = marker.normal_cam.cross(e1);
  double u_min = 1e6, v_min = 1e6, u_max = -1e6, v_max = -1e6;
  for (int i = 0; i < kSides; ++i) {
    const auto turn = math::sin_cos(2 * 3.14159265358979323846 / kSides * i);
    const Vec<double, 3> p = marker.centre_cam_m + kAround * radius_m * (turn.cos * e1 + turn.sin * e2);
    if (!(p.z() > kNearest_m)) return {};
    const Vec<double, 2> pixel = camera_.project(p.hnormalized());
    u_min = std::min(u_min, pixel.x()), u_max = std::max(u_max, pixel.x());
    v_min = std::min(v_min, pixel.y()), v_max = std::max(v_max, pixel.y());
  }
  const double width = camera_.parameters().width_px, height = camera_.parameters().height_px;
  return {static_cast<int>(std::clamp(u_min - 1, 0.0, width)), static_cast<int>(std::clamp(v_min - 1, 0.0, height)),
          static_cast<int>(std::clamp(u_max + 2, -1.0, width - 1)),
          static_cast<int>(std::clamp(v_max + 2, -1.0, height - 1))};
}

/// Calls paint(grey level, share of the pixel covered) for every pixel that the disc touches.
template <class Paint>
void Renderer::paint_disc(const SceneMarker& marker, double radius_m, const Paint& paint) {
  const PixelBox box = image_box(marker, radius_m);
  const ImagedDisc disc{marker.centre_cam_m, marker.normal_cam, radius_m};
  const double bend = disc.bend(largest_step_);
  const auto side = [&](int column, int row) {
    const double value = disc.side(corner_ray(column, row));
    return value == value ? value : std::numeric_limits<double>::infinity();
  };
  for (int v = box.v_min_px; v <= box.v_max_px; ++v) {
    double upper_left = side(box.u_min_px, v), lower_left = side(box.u_min_px, v + 1);
    for (int u = box.u_min_px; u <= box.u_max_px; ++u) {
      const double upper_right = side(u + 1, v), lower_right = side(u + 1, v + 1);
      const auto [nearest, farthest] = std::minmax({upper_left, upper_right, lower_left, lower_right});
      std::int16_t& grey = sharp_.row(v)[u];
      if (farthest < -bend) {
        paint(grey, 1.0);
      } else if (nearest <= bend) {
        paint(grey,
              disc.coverage({corner_ray(u, v), corner_ray(u + 1, v), corner_ray(u, v + 1), corner_ray(u + 1, v + 1)}));
      }
      upper_left = upper_right;
      lower_left = lower_right;
    }
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

PixelBox Renderer::move(const PixelBox& box) {
  if (motion_.still()) return box;
  const PixelBox reached = grown(box, motion_.reach_px(), moved_);
  motion_.apply(sharp_, reached, moved_);
  return reached;
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
