#pragma once
/// @file  The pictures of a run: its start, its most eventful frame, and a film around that.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "host_sim/report/camera_picture.hpp"
#include "host_sim/report/figure.hpp"
#include "host_sim/report/moments.hpp"
#include "host_sim/report/run_record.hpp"
#include "host_sim/world/object_state.hpp"

namespace articam::sim {

template <class Model>
std::vector<SceneMarker> scene_markers(const PlainConfiguration& plain) {
  model::Configuration<Model, double> q;
  q.T_cam_obj = plain.T_cam_obj;
  for (int j = 0; j < model::kNumJoints<Model>; ++j) q.joints[j] = plain.joints[static_cast<std::size_t>(j)];
  return scene_markers<Model>(q);
}

template <class Model>
Overlay overlay_of(const FrameRecord& frame) {
  Overlay overlay{frame.seen, {}, {}, fmt::format("{:.2f} s, {}", frame.t_s, tracker::name(frame.status))};
  if (frame.estimate) overlay.estimated = scene_markers<Model>(*frame.estimate);
  if (frame.rival) overlay.rival = scene_markers<Model>(*frame.rival);
  return overlay;
}

/// `Loop` exposes a frame once more: image_of(frame), camera().
template <class Model, class Loop>
std::vector<Figure> take_pictures(const RunRecord& run, Loop& loop) {
  const Moments chosen = moments(run);
  const CameraParameters& camera = loop.camera();
  std::vector<Figure> pictures;
  const auto still = [&](std::size_t i, std::string name, std::string caption) {
    const Crop whole{0, 0, camera.width_px, camera.height_px};
    const FrameRecord& frame = run.frames[i];
    const std::string layers = picture_layers(loop.image_of(frame), camera, overlay_of<Model>(frame), whole);
    pictures.push_back({std::move(name), std::move(caption), camera_picture(layers, whole)});
  };
  std::vector<Overlay> overlays;
  for (const std::size_t i : chosen.film) overlays.push_back(overlay_of<Model>(run.frames[i]));
  const Crop crop = around(overlays, camera);
  std::vector<std::string> shots;
  for (std::size_t k = 0; k < overlays.size(); ++k) {
    shots.push_back(picture_layers(loop.image_of(run.frames[chosen.film[k]]), camera, overlays[k], crop));
  }
  pictures.push_back({"film",
                      run.frames[chosen.event].status == tracker::TrackingStatus::tracking
                          ? "The fastest motion of the run, as fast as it was; enlarged."
                          : "The first frames that were not fully tracked, and those around them; enlarged.",
                      camera_film(shots, 1 / kFilmRate_hz, crop)});
  still(chosen.event, "camera_event", "A whole frame of it, as the camera sees it.");
  still(chosen.start, "camera_start", "Soon after the start.");
  return pictures;
}

}  // namespace articam::sim
