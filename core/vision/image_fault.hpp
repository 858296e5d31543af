#pragma once
/// @file  What is wrong with a frame as a whole.

#include <cstdint>

#include "core/vision/image_view.hpp"

namespace articam::vision {

enum class ImageFault : std::uint8_t {
  none,
  overexposed,   ///< more than a quarter is white
  underexposed,  ///< all but a hundredth is nearly black
  blurred,       ///< no edge is sharper than sigma 3 px
};

/// Judges every 16th row: a sixteenth of the work of one pass. A frame without contrast may show an even wall: none.
/// `image` is ok().
ImageFault fault_of(const ImageView& image) noexcept;

}  // namespace articam::vision
