#pragma once
/// @file  A number for each start of the board's program.

#include <cstdint>

namespace articam::hal {

/// Drawn from the kernel's random numbers, so that a receiver tells two starts apart. Never 0. Not a secret.
std::uint64_t draw_session() noexcept;

}  // namespace articam::hal
