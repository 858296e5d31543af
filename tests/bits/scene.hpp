#pragma once
/// @file  A recording that every machine draws for itself, the same to the bit.

#include <cstdint>
#include <span>

#include "core/camera_parameters.hpp"
#include "core/vision/image_view.hpp"

namespace articam::test {

/// The printer's six rings before a camera without distortion, 30 frames a second: base and drawer move, a ring is
/// hidden for a while, then all of them are.
///
/// Nothing is read and no libm is called: the outlines of the rings are conics computed by + - x / in double and
/// rounded to integers; every pixel, with its edge, its noise and the light's gradient, is made of integers alone.
struct Scene {
  static constexpr int kWidth_px = 640, kHeight_px = 480, kFrames = 200;
  static constexpr double kRate_hz = 30;
  static constexpr std::size_t kPixels = std::size_t{kWidth_px} * kHeight_px;

  static CameraParameters camera() noexcept;
  /// Frame k, of kFrames, into storage for kPixels, rows without gaps.
  static ImageView draw(std::uint32_t k, std::span<std::uint8_t, kPixels> pixels) noexcept;
};

}  // namespace articam::test
