#pragma once
/// @file  A part of the robot that is in the camera's way.

#include <span>

#include "core/vision/camera_model.hpp"
#include "core/vision/image_view.hpp"
#include "host_sim/world/grey_plane.hpp"

namespace articam::sim {

/// All that is nearer than the radius to a straight line. Frames  {cam}. Units  m.
struct Limb {
  Vec<double, 3> from_cam_m, to_cam_m;
  double radius_m{};

  struct Clearance {
    double way_m;    ///< from the ray to the surface; negative: the ray meets the limb
    double depth_m;  ///< along the ray, where that is; negative: behind the camera
  };
  /// Of a ray from the camera's centre, of any length.
  Clearance clearance(const Vec<double, 3>& ray) const noexcept;

  bool hides(const Vec<double, 3>& p_cam) const noexcept {
    const Clearance to = clearance(p_cam);
    return to.way_m < 0 && to.depth_m > 0;
  }
};

/// The pixels that a limb may touch.
PixelBox image_box(const Limb& limb, const vision::CameraModel<double>& camera) noexcept;

/// Paints the pixel of that ray: mid grey with a dark contour, over whatever lies there. What is nearer than 1 cm is
/// left out.
void paint_limb(const Limb& limb, const Vec<double, 3>& ray, double focal_px, std::int16_t& grey) noexcept;

/// Share of a disc's edge and centre that limbs hide, 0 to 1: of seventeen points.
double hidden_share(std::span<const Limb> limbs, const Vec<double, 3>& centre_cam_m, const Vec<double, 3>& normal_cam,
                    double radius_m) noexcept;

}  // namespace articam::sim
