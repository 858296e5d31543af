#pragma once
/// @file  The sizes and the number type that the firmware is built with.

#include <cstddef>

namespace articam {

/// The scalar of the programs' estimators. The tracker is instantiated for float and double alike.
using DefaultScalar = double;

inline constexpr int kMaxImageWidth_px = 1280;
inline constexpr int kMaxImageHeight_px = 960;

/// Detections kept of one frame; what exceeds it is dropped and the frame is flagged as overloaded.
inline constexpr std::size_t kMaxDetections = 64;

}  // namespace articam
