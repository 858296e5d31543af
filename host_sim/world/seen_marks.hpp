#pragma once
/// @file  Detections without an image: where the marks' edges truly are, with a detector's noise.

#include <span>

#include "core/vision/detection.hpp"
#include "core/vision/plane_ellipse.hpp"
#include "host_sim/world/hash.hpp"
#include "host_sim/world/renderer.hpp"

namespace articam::sim {

/// What the detector measured of its own noise, and says of it, in rendered frames of noise 1 to 10 grey levels, blur
/// 0.7 px and rings of 9 to 40 px radius: a standard deviation of the centre of
///     sqrt(0.0025^2 + (0.0064 noise)^2 / radius) px;
/// of the axes three halves of that variance, and a bias of up to 0.25 px^2 / radius that it only owns to.
struct EdgeNoise {
  double centre_px2, axis_px2;  ///< variances that it has
  double owned_axis_px2;        ///< that it reports
};
EdgeNoise edge_noise(double radius_px, double noise_grey) noexcept;

/// About normal: the sum of twelve. Ends at 6 sigma.
double normal(Dice& dice) noexcept;

/// The ellipse of a true edge as a detector would measure it.
vision::Ellipse measured(const vision::PlaneEllipse<double>& edge, const EdgeNoise& noise, Dice& dice) noexcept;

std::uint32_t variance_q24(double variance_px2) noexcept;

/// All marks wholly in the image and in view, each as its own row shows it. Of the outer edge limbs may hide a tenth.
void see_marks(std::span<const SceneMarker> markers, std::span<const Limb> limbs,
               const vision::CameraModel<double>& camera, double noise_grey, Dice& dice,
               vision::Detections& out) noexcept;

}  // namespace articam::sim
