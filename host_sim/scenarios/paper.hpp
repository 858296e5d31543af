#pragma once
/// @file  The experiment of the paper, with a ground truth.

#include "core/camera_parameters.hpp"
#include "core/math/so3.hpp"
#include "host_sim/dynamics/urdf_texts.hpp"
#include "host_sim/scenarios/scenario.hpp"
#include "host_sim/world/drawer_motion.hpp"
#include "host_sim/world/object_state.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"

namespace articam::sim {

/// A printer stands before a VGA camera; its drawer rests for five seconds, then opens and closes as by a perfect hand.
struct PaperScenario {
  using Model = models::PrinterDrawer;
  static constexpr double kDuration_s = 60;
  static constexpr DrawerMotion kDrawer{};
  static constexpr double kRest_s = kDrawer.rest_s;  ///< how long nothing moves at the start

  static CameraParameters camera() noexcept {
    CameraParameters camera;
    camera.width_px = 640, camera.height_px = 480;
    camera.fx_px = camera.fy_px = 525;
    camera.cx_px = 319.5, camera.cy_px = 239.5;
    return camera;
  }

  /// q2, the distance of the drawer's two markers, does not move: it is to be identified.
  static ObjectState<Model> at(double t_s) noexcept {
    constexpr double kDeg = 3.14159265358979323846 / 180;
    ObjectState<Model> object;
    object.q.T_cam_obj.t = {0.02, 0.08, 0.70};
    object.q.T_cam_obj.R = math::exp_so3<double>({0, 0, 5 * kDeg}) * math::exp_so3<double>({0, -10 * kDeg, 0}) *
                           math::exp_so3<double>({30 * kDeg, 0, 0});
    const JointMotion drawer = kDrawer.at(t_s);
    object.q.joints = {drawer.position, 0.12};
    object.qdot[6] = drawer.velocity;
    return object;
  }
};

/// No robot.
inline Scenario<PaperScenario::Model> drawer_scenario() {
  return {.name = "drawer",
          .summary = "a printer's drawer rests, then opens and closes at up to 50 mm/s; no robot",
          .duration_s = PaperScenario::kDuration_s,
          .rest_s = PaperScenario::kRest_s,
          .camera = PaperScenario::camera(),
          .rest = PaperScenario::at(0),
          .motion = &PaperScenario::at};
}

/// The same for as many frames as one likes: `--level features --duration 33334` are a million.
inline Scenario<PaperScenario::Model> soak_scenario() {
  auto soak = drawer_scenario();
  soak.name = "soak";
  soak.summary = "the same for 10,000 frames, or as many as --duration says; only their status is kept";
  soak.duration_s = 333.4;
  soak.for_soaking = true;
  return soak;
}

/// A robot that faces the printer holds its drawer: x into the printer, z up.
inline Pull pull_of_the_drawer() {
  Pull pull;
  pull.object_urdf = urdf::kPrinterDrawer;
  pull.joint = models::PrinterDrawer::Joint::kDrawerSlide;
  pull.handle_link = "drawer";
  pull.handle_m = {0, 0.1, -0.02};
  pull.R_obj_base << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  pull.settled = 0.003;
  return pull;
}

/// Section V: the hand is at the drawer from the start, control is switched on at 15 s, then a user opens and closes.
inline Scenario<PaperScenario::Model> paper_scenario() {
  auto paper = drawer_scenario();
  paper.name = "paper";
  paper.summary = "section V: from 15 s on a robot opens and closes the drawer that it only sees";
  paper.rest_s = 15;
  paper.motion = nullptr;
  paper.pull = pull_of_the_drawer();
  paper.pull->commands = {{15, 0.02}, {17, 0.10}, {24, 0.05}, {30, 0.12},
                          {37, 0.03}, {44, 0.07}, {50, 0.11}, {54, 0.02}};
  return paper;
}

}  // namespace articam::sim
