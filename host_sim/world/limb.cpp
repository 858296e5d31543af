#include "host_sim/world/limb.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/trigonometry.hpp"
#include "host_sim/world/pixel_bounds.hpp"

namespace articam::sim {
namespace {

constexpr double kNearest_m = 0.01;
constexpr double kSkin_grey = 110, kContour_grey = 45;
constexpr double kContour_px = 2;

}  // namespace

/// Seen along the ray the limb's line is a line in a plane, and the ray a point.
Limb::Clearance Limb::clearance(const Vec<double, 3>& ray) const noexcept {
  const Vec<double, 3> d = ray.normalized(), way = to_cam_m - from_cam_m;
  const Vec<double, 3> from = from_cam_m - from_cam_m.dot(d) * d, across = way - way.dot(d) * d;
  const double across2 = across.squaredNorm();
  const double s = across2 > 0 ? std::clamp(-from.dot(across) / across2, 0.0, 1.0) : 0;
  return {(from + s * across).norm() - radius_m, (from_cam_m + s * way).dot(d)};
}

PixelBox image_box(const Limb& limb, const vision::CameraModel<double>& camera) noexcept {
  const CameraParameters& size = camera.parameters();
  PixelBounds bounds;
  for (const Vec<double, 3>& end : {limb.from_cam_m, limb.to_cam_m}) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const auto side = [corner](unsigned bit) { return (corner & bit) != 0 ? 1.0 : -1.0; };
      const Vec<double, 3> p = end + limb.radius_m * Vec<double, 3>{side(1), side(2), side(4)};
      if (!(p.z() > kNearest_m)) return {0, 0, size.width_px - 1, size.height_px - 1};
      bounds.add(camera.project(p.hnormalized()));
    }
  }
  return bounds.within(size);
}

void paint_limb(const Limb& limb, const Vec<double, 3>& ray, double focal_px, std::int16_t& grey) noexcept {
  const Limb::Clearance to = limb.clearance(ray);
  if (!(to.depth_m > kNearest_m)) return;
  const double inside_px = -to.way_m / to.depth_m * focal_px;
  const double share = std::clamp(inside_px + 0.5, 0.0, 1.0);
  const double skin = std::clamp(inside_px - kContour_px + 0.5, 0.0, 1.0);
  const double contour = grey_q6(kContour_grey), difference = grey_q6(kSkin_grey - kContour_grey);
  grey = static_cast<std::int16_t>(grey + share * (contour - grey) + skin * difference + 0.5);
}

double hidden_share(std::span<const Limb> limbs, const Vec<double, 3>& centre_cam_m, const Vec<double, 3>& normal_cam,
                    double radius_m) noexcept {
  if (limbs.empty()) return 0;
  constexpr int kOnEdge = 16;
  const auto is_hidden = [limbs](const Vec<double, 3>& p) {
    return std::ranges::any_of(limbs, [&p](const Limb& limb) { return limb.hides(p); });
  };
  const Vec<double, 3> e1 = normal_cam.unitOrthogonal(), e2 = normal_cam.cross(e1);
  int hidden = is_hidden(centre_cam_m) ? 1 : 0;
  for (int i = 0; i < kOnEdge; ++i) {
    const auto turn = math::sin_cos(2 * 3.14159265358979323846 / kOnEdge * i);
    hidden += is_hidden(centre_cam_m + radius_m * (turn.cos * e1 + turn.sin * e2)) ? 1 : 0;
  }
  return hidden / (kOnEdge + 1.0);
}

}  // namespace articam::sim
