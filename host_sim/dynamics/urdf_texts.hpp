#pragma once
/// @file  The URDF files of what is simulated, as they stand in the repository: programs need no file at run time.

#include <string_view>

namespace articam::sim::urdf {

extern const std::string_view kHumanoidArm;  ///< host_sim/robot
// static_models
extern const std::string_view kPrinterDrawer, kDoor, kValve, kCabinet;

}  // namespace articam::sim::urdf
