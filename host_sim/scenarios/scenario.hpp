#pragma once
/// @file  A scenario, as data: who stands where, what happens, and what must come of it.

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "core/camera_parameters.hpp"
#include "core/tracker/tracking_status.hpp"
#include "host_sim/scenarios/pull.hpp"
#include "host_sim/world/object_state.hpp"

namespace articam::sim {

/// In [from_s, to_s) every estimate says this, or what another expectation says of the same time.
struct Expected {
  double from_s{}, to_s{};
  tracker::TrackingStatus status{};
  tracker::Reason reason{};
};

template <class M>
struct Scenario {
  using Model = M;

  std::string_view name, summary;
  double duration_s{};
  double rest_s{};  ///< how long nothing but the robot's sway moves at the start
  CameraParameters camera{};
  ObjectState<Model> rest{};                               ///< at the start
  std::optional<Pull> pull{};                              ///< a robot moves it; otherwise
  std::function<ObjectState<Model>(double t_s)> motion{};  ///< it moves by itself
  std::vector<Fault> faults{};
  std::vector<Expected> expected{};
  bool for_soaking{false};  ///< long: nothing is kept of a frame but its status
};

}  // namespace articam::sim
