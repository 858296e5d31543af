#pragma once
/// @file  Which camera, and which settings, before anything is configured.

#include "hal/capture/start_problem.hpp"
#include "hal/libcamera/capture_device.hpp"
#include "hal/libcamera/libcamera_camera.hpp"

namespace articam::hal {

/// The id that the user means by an id, a number in the list, or nothing for the first camera.
/// Errors  throws StartProblem no_device; the reason lists what there is.
std::string choose_camera(const std::vector<std::string>& ids, const std::string& wanted);

/// Errors  throws StartProblem bad_argument where the camera cannot fix what the options fix, or not at this value. A
///         camera that cannot set its frame duration keeps its own.
Controls choose_controls(const Abilities& abilities, const LibcameraOptions& options);

}  // namespace articam::hal
