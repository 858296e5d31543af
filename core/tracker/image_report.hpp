#pragma once
/// @file  What an image itself has to do with what was seen in it.

#include "core/tracker/tracking_status.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/image_fault.hpp"

namespace articam::tracker {

/// What is known of a frame beside its marks.
struct ImageReport {
  bool overloaded{};           ///< it exceeded the detector's capacities: marks may be missing
  Reason fault{Reason::none};  ///< overexposed, underexposed or blurred
};

/// Where marks are missing, what is wrong with the frame; otherwise what is wrong with most of its marks.
/// `expected`: how many marks should be there.  Reason::none: the image is not to blame.
inline Reason blame_image(const ImageView& image, const vision::Detections& marks, int expected) noexcept {
  if (static_cast<int>(marks.size()) < expected) {
    switch (vision::fault_of(image)) {
      case vision::ImageFault::overexposed:
        return Reason::overexposed;
      case vision::ImageFault::underexposed:
        return Reason::underexposed;
      case vision::ImageFault::blurred:
        return Reason::blurred;
      case vision::ImageFault::none:
        break;
    }
  }
  std::size_t saturated = 0, blurred = 0;
  for (const vision::Detection& mark : marks) {
    saturated += (mark.flaws & vision::kSaturated) != 0 ? 1 : 0;
    blurred += (mark.flaws & vision::kBlurred) != 0 ? 1 : 0;
  }
  if (2 * saturated > marks.size()) return Reason::overexposed;
  return 2 * blurred > marks.size() ? Reason::blurred : Reason::none;
}

}  // namespace articam::tracker
