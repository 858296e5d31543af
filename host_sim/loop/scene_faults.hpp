#pragma once
/// @file  A scenario's faults, as the camera meets them.

#include <span>
#include <vector>

#include "host_sim/ports/sim_camera.hpp"
#include "host_sim/scenarios/scenario.hpp"
#include "host_sim/world/renderer.hpp"

namespace articam::sim {

/// `amount` of the fault of that kind at an instant; `otherwise` where there is none.
double fault_at(std::span<const Fault> faults, FaultKind kind, double t_s, double otherwise) noexcept;

/// What becomes of frame k; which frames are dropped depends on the seed.
FrameFate fate_of(std::span<const Fault> faults, double t_s, std::uint32_t k, std::uint64_t seed) noexcept;

/// Leaves hidden markers out, moves one or all, and puts planted ones in.
void apply(std::span<const Fault> faults, double t_s, std::vector<SceneMarker>& markers);

/// What of frame k's buffer is said to be there.
ImageView cut(std::span<const Fault> faults, double t_s, std::uint32_t k, ImageView frame) noexcept;

/// How a frame is rendered at an instant.
RenderOptions rendering_at(std::span<const Fault> faults, double t_s, const RenderOptions& usual) noexcept;

}  // namespace articam::sim
