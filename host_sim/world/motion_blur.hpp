#pragma once
/// @file  What moves straight while the shutter is open, in integers.

#include <vector>

#include "core/math/types.hpp"
#include "core/vision/image_view.hpp"
#include "host_sim/world/grey_plane.hpp"

namespace articam::sim {

/// The mean of the image along a line whose middle is the pixel: what is drawn is where things are at mid-exposure.
/// Between pixels the image is taken for bilinear, which blurs by a sixth of a squared pixel on its own.
class MotionBlur {
 public:
  /// The whole way, px; zero copies.
  explicit MotionBlur(const Vec<double, 2>& motion_px);

  bool still() const noexcept { return taps_.size() == 1; }
  int reach_px() const noexcept { return reach_px_; }

  /// Blurs the pixels of `box` (within the image) from `sharp` into `moved`; the border repeats outwards.
  void apply(const GreyPlane& sharp, const PixelBox& box, GreyPlane& moved) const;

 private:
  struct Tap {
    int du_px, dv_px, weight_q14;  ///< all weights together are 2^14
  };
  std::vector<Tap> taps_;
  int reach_px_{};
};

}  // namespace articam::sim
