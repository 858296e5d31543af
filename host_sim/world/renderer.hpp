#pragma once
/// @file  Camera frames of flat markers, exact under perspective, the same bytes on every machine.

#include <array>
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
#include "host_sim/world/motion_blur.hpp"

namespace articam::sim {

/// A flat marker as the camera meets it. Frames  {cam}. Units  m.
struct SceneMarker {
  model::MarkerKind kind{};
  Vec<double, 3> centre_cam_m;
  Vec<double, 3> normal_cam;  ///< outward unit normal
  double outer_radius_m{};    ///< of a dot: its radius
  double inner_radius_m{};    ///< of a ring; 0 otherwise
};

struct RenderOptions {
  double blur_px = 0.7;       ///< sigma of the lens, 0 to 5
  double noise_grey = 4;      ///< sigma of the sensor's noise in grey levels, 0 to 100
  std::uint64_t seed = 1;     ///< of the clutter and of the noise
  bool clutter = true;        ///< false: an even grey wall
  double light_gradient = 1;  ///< brightest to darkest side, left to right; at least 1
  double exposure = 1;        ///< light by what is right, 0 to 2; beyond 1.19 the brightest cards saturate
  /// How far the image moves while it is exposed, each component up to 50 px; markers are where they are half-way.
  std::array<double, 2> motion_px{};
};

/// The still background is painted once; a frame costs the marker's edges, their blur and one pass of noise.
/// Each marker sits on its own round card of 1.4 times its diameter: light under a ring or a dark dot, dark under a
/// light dot. A marker seen from behind, or reaching nearer than 1 cm, is left out. Later markers hide earlier ones.
class Renderer {
 public:
  Renderer(const CameraParameters& camera, const RenderOptions& options);

  /// The frame of that index: `pixels` becomes width x height grey levels, row by row, independent of earlier calls.
  void render(std::span<const SceneMarker> markers, std::uint64_t frame_index, std::vector<std::uint8_t>& pixels);

  const CameraParameters& camera() const noexcept { return camera_.parameters(); }

 private:
  Vec<double, 3> corner_ray(int column, int row) const noexcept;
  PixelBox image_box(const SceneMarker& marker, double radius_m) const noexcept;
  PixelBox paint_marker(const SceneMarker& marker);
  PixelBox move(const PixelBox& box);
  template <class Paint>
  void paint_disc(const SceneMarker& marker, double radius_m, const Paint& paint);
  void light(const PixelBox& box);

  vision::CameraModel<double> camera_;
  std::vector<Vec<double, 2>> corner_rays_;  ///< metric plane, of the pixels' corners: (width + 1) x (height + 1)
  double largest_step_{};                    ///< between neighbouring corners, metric plane
  std::vector<int> light_q14_;               ///< brightness of each column
  MotionBlur motion_;
  GaussianBlur blur_;
  GaussianNoise noise_;
  GreyPlane background_;            ///< sharp, evenly lit
  GreyPlane moved_background_;      ///< the same while it moves
  GreyPlane soft_background_;       ///< blurred and lit
  GreyPlane sharp_, moved_, soft_;  ///< the same three with this frame's markers
};

}  // namespace articam::sim
