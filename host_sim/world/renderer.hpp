#pragma once
/// @file  Camera frames of flat markers, exact under perspective, the same bytes on every machine.

#include <cstdint>
#include <span>
#include <vector>

#include "core/camera_parameters.hpp"
#include "core/math/types.hpp"
#include "core/model/model_table.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/image_view.hpp"
#include "host_sim/world/gaussian_blur.hpp"
#include "host_sim/world/gaussian_noise.hpp"
#include "host_sim/world/grey_plane.hpp"
#include "host_sim/world/imaged_disc.hpp"
#include "host_sim/world/limb.hpp"

namespace articam::sim {

/// A flat marker as the camera meets it at mid-exposure of the first row. Frames  {cam}. Units  m, m/s, rad/s.
struct SceneMarker {
  model::MarkerKind kind{};
  Vec<double, 3> centre_cam_m;
  Vec<double, 3> normal_cam;                                ///< outward unit normal
  double outer_radius_m{};                                  ///< of a dot: its radius
  double inner_radius_m{};                                  ///< of a ring; 0 otherwise
  Vec<double, 3> velocity{Vec<double, 3>::Zero()};          ///< of the centre
  Vec<double, 3> angular_velocity{Vec<double, 3>::Zero()};  ///< about the centre
};

struct RenderOptions {
  double blur_px = 0.7;            ///< sigma of the lens, 0 to 5
  double noise_grey = 4;           ///< sigma of the sensor's noise in grey levels, 0 to 100
  std::uint64_t seed = 1;          ///< of the clutter and of the noise
  bool clutter = true;             ///< false: an even grey wall
  double light_gradient = 1;       ///< brightest to darkest side, left to right; at least 1
  double exposure = 1;             ///< light by what is right, 0 to 2; beyond 1.19 the brightest cards saturate
  double exposure_time_s = 0.008;  ///< of each row; what moves is smeared along its own way, as in a lit room
};

/// The still background is painted once; a frame costs the marker's edges, their blur and one pass of noise.
/// Each marker sits on its own round card of 1.4 times its diameter: light under a ring or a dark dot, dark under a
/// light dot. A marker seen from behind, or reaching nearer than 1 cm, is left out. Later markers hide earlier ones,
/// and limbs hide markers. Row v is exposed about readout_time_s v / (height - 1) after the first, as
/// core/tracker/rolling_shutter.hpp has it; it shows the mean of the markers on their way, each of them exact.
class Renderer {
 public:
  Renderer(const CameraParameters& camera, const RenderOptions& options);

  /// The frame of that index: `pixels` becomes width x height grey levels, row by row, independent of earlier calls.
  void render(std::span<const SceneMarker> markers, std::uint64_t frame_index, std::vector<std::uint8_t>& pixels,
              std::span<const Limb> limbs = {});

  /// RenderOptions::exposure from now on.
  void set_exposure(double exposure);

  const CameraParameters& camera() const noexcept { return camera_.parameters(); }

 private:
  /// A disc on its way: once where it rests, else so often while a row is exposed.
  struct Passage {
    int instants;
    double from_s, to_s;  ///< of the whole frame
  };

  Vec<double, 3> corner_ray(int column, int row) const noexcept;
  Passage passage(const SceneMarker& marker) const noexcept;
  PixelBox image_box(const SceneMarker& marker, double radius_m) const noexcept;
  PixelBox paint_marker(const SceneMarker& marker);
  PixelBox paint_limb(const Limb& limb);
  template <class Paint>
  void paint_disc(const SceneMarker& marker, double radius_m, const Paint& paint);
  void cover(const ImagedDisc& disc, int v, int u_min, int u_max) noexcept;
  void light(const PixelBox& box);

  vision::CameraModel<double> camera_;
  double exposure_time_s_, light_gradient_;
  std::vector<Vec<double, 2>> corner_rays_;  ///< metric plane, of the pixels' corners: (width + 1) x (height + 1)
  double largest_step_{};                    ///< between neighbouring corners, metric plane
  double exposure_{-1};
  std::vector<int> light_q14_;   ///< brightness of each column
  std::vector<double> covered_;  ///< of one row: shares of its pixels, summed over instants
  GaussianBlur blur_;
  GaussianNoise noise_;
  GreyPlane background_;       ///< sharp, evenly lit
  GreyPlane soft_background_;  ///< blurred
  GreyPlane lit_background_;   ///< and lit
  GreyPlane sharp_, soft_;     ///< with this frame's markers: sharp, evenly lit; blurred and lit
};

}  // namespace articam::sim
