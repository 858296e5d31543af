#pragma once
/// @file  The softness of a lens: a separable Gaussian, in integers.

#include <vector>

#include "core/vision/image_view.hpp"
#include "host_sim/world/grey_plane.hpp"

namespace articam::sim {

class GaussianBlur {
 public:
  /// sigma_px 0 copies. The kernel reaches to 4 sigma.
  explicit GaussianBlur(double sigma_px);

  int reach_px() const noexcept { return static_cast<int>(weights_q14_.size()) - 1; }

  /// Blurs the pixels of `box` (within the image) from `sharp` into `soft`; the border repeats outwards.
  void apply(const GreyPlane& sharp, const PixelBox& box, GreyPlane& soft);

 private:
  std::vector<int> weights_q14_;  ///< centre first, then one side; both sides together sum to 2^14
  std::vector<int> rows_q6_;      ///< the box blurred along rows, with `reach` rows more above and below
};

}  // namespace articam::sim
