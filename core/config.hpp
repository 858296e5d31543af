#pragma once
/// @file  The sizes and the number type that the firmware is built with.

#include <cstddef>

namespace articam {

/// The scalar of the programs' estimators. The tracker is instantiated for float and double alike.
using DefaultScalar = double;

/// The largest frame. The detector's buffers are made for it: 79 kB at 1280 x 960, 20 kB at 640 x 480. A build for a
/// small board chooses less, by the CMake variables ARTICAM_MAX_IMAGE_WIDTH and ARTICAM_MAX_IMAGE_HEIGHT.
#if defined(ARTICAM_MAX_IMAGE_WIDTH) && defined(ARTICAM_MAX_IMAGE_HEIGHT)
inline constexpr int kMaxImageWidth_px = ARTICAM_MAX_IMAGE_WIDTH;
inline constexpr int kMaxImageHeight_px = ARTICAM_MAX_IMAGE_HEIGHT;
#else
inline constexpr int kMaxImageWidth_px = 1280;
inline constexpr int kMaxImageHeight_px = 960;
#endif

/// Detections kept of one frame; what exceeds it is dropped and the frame is flagged as overloaded.
inline constexpr std::size_t kMaxDetections = 64;

}  // namespace articam
