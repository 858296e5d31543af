#pragma once
/// @file  Rendered frames of a printer whose drawer is pulled while a camera goes around it.

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "core/math/so3.hpp"
#include "hal/replay/pgm.hpp"
#include "host_sim/world/object_state.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"

namespace articam::test {

struct Orbit {
  CameraParameters camera;
  Vec<double, 3> displaced{Vec<double, 3>::Zero()};  ///< of base_marker_1, m, {obj}
  double distance_m{0.12};                           ///< marker_distance
  int num_frames{200};
};

/// The camera swings by 35 degrees about two axes and goes from 0.55 to 0.85 m while the drawer goes from 2 to 18 cm.
inline model::Configuration<models::PrinterDrawer, double> at(const Orbit& orbit, double turn) {
  constexpr double kSwing = 0.6;  // rad
  model::Configuration<models::PrinterDrawer, double> q;
  const Quat<double> R = math::exp_so3<double>({kSwing * std::sin(3 * turn), 0, 0}) *
                         math::exp_so3<double>({0, kSwing * std::sin(5 * turn + 1), 0}) *
                         math::exp_so3<double>({0, 0, 0.5 * std::sin(2 * turn)});
  const Vec<double, 3> middle{0, 0, -0.05};  // {obj}, where it looks
  q.T_cam_obj.R = R;
  q.T_cam_obj.t =
      Vec<double, 3>{0.05 * std::sin(7 * turn), 0.04 * std::cos(4 * turn), 0.7 - 0.15 * std::cos(turn)} - R * middle;
  q.joints = {0.1 - 0.08 * std::cos(6 * turn), orbit.distance_m};
  return q;
}

/// Writes frame_10000.pgm, ... Empty, or what went wrong.
inline std::string draw(const Orbit& orbit, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  sim::Renderer renderer{orbit.camera, {.seed = 7}};
  std::string why;
  for (int i = 0; i < orbit.num_frames && why.empty(); ++i) {
    const auto q = at(orbit, 2 * std::numbers::pi * i / orbit.num_frames);
    auto markers = sim::scene_markers<models::PrinterDrawer>(q);
    markers[1].centre_cam_m += q.T_cam_obj.R * orbit.displaced;
    std::vector<std::uint8_t> pixels;
    renderer.render(markers, static_cast<std::uint64_t>(i), pixels);
    const std::string name = "frame_" + std::to_string(10000 + i) + ".pgm";
    (void)hal::write_pgm(folder / name,
                         {pixels.data(), orbit.camera.width_px, orbit.camera.height_px, orbit.camera.width_px}, why);
  }
  return why;
}

}  // namespace articam::test
