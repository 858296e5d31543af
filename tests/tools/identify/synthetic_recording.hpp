#pragma once
/// @file  Recordings of objects that are not quite what their model says, seen by cameras that their file does not
///        describe quite.

#include "core/tracker/features.hpp"
#include "core/tracker/joint_range.hpp"
#include "static_models/cameras/xtion_vga.hpp"
#include "tests/support/random_views.hpp"

#include "tools/identify/object.hpp"
#include "tools/identify/recording.hpp"

namespace articam::test {

/// The truth. `displaced` (m, on the body) is what the model does not know of a marker.
template <class M>
struct World {
  CameraParameters camera = cameras::kXtionVga;
  std::array<Vec<double, 3>, static_cast<std::size_t>(model::kNumMarkers<M>)> displaced{};
  double noise_px{0.02};

  World() { displaced.fill(Vec<double, 3>::Zero()); }

  /// What a detector sees of q, and where a tracker that believes in the model may think that q is.
  identify::Moment look(const model::Configuration<M, double>& q, Random& random) const {
    const vision::CameraModel<double> lens{camera};
    const auto kinematics = model::forward_kinematics<M, double>(q.joints);
    identify::Moment moment;
    for (std::size_t i = 0; i < M::kMarkers.size(); ++i) {
      const model::MarkerRow& row = M::kMarkers[i];
      auto place = kinematics.markers[i];
      const Vec<double, 3>& d = displaced[i];
      place.centre += row.body < 0 ? d : kinematics.T_obj_body[static_cast<std::size_t>(row.body)].R * d;
      const auto image = tracker::image_of(tracker::circle_in_camera(q.T_cam_obj, place, row.outer_diameter_m), lens);
      if (!image.ok()) continue;
      moment.sightings.push_back(
          {i, image.value().centre + noise_px * Vec<double, 2>{random.gaussian(), random.gaussian()},
           noise_px * noise_px, 0});
    }
    constexpr double kAbout_m = 0.002, kAbout_rad = 0.005;
    moment.T_cam_obj.t = q.T_cam_obj.t + kAbout_m * random.vector<double, 3>(-1, 1);
    moment.T_cam_obj.R = math::exp_so3<double>(kAbout_rad * random.vector<double, 3>(-1, 1)) * q.T_cam_obj.R;
    for (int j = 0; j < model::kNumJoints<M>; ++j) {
      moment.joints.push_back(q.joints[j] + kAbout_m * random.gaussian());
      moment.joint_deviations.push_back(kAbout_m);
    }
    return moment;
  }
};

/// Views from everywhere, the joints anywhere, but those of `still` where it says.
template <class M>
identify::Recording record(const World<M>& world, const std::vector<std::pair<int, double>>& still, int num_moments,
                           Random& random, const ViewLimits& limits = {0.5, 1.2, 0.8}) {
  identify::Recording recording;
  for (int i = 0; i < num_moments; ++i) {
    auto q = random_view<M>(vision::CameraModel<double>{world.camera}, limits, random);
    for (const auto& [joint, value] : still) q.joints[joint] = value;
    recording.push_back(world.look(q, random));
  }
  return recording;
}

}  // namespace articam::test
