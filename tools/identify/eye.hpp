#pragma once
/// @file  A camera whose calibration may be a little wrong: where it sees a mark, and how every number moves that.

#include <optional>
#include <vector>

#include "core/camera_parameters.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/imaged_circle.hpp"

namespace articam::identify {

/// What to add to a calibration. The two focal lengths are f exp(-+ aspect / 2), so that `focal` is what a zoom
/// changes, and `aspect` what nothing should.
struct CameraChange {
  enum Index { kFocal, kAspect, kCx, kCy, kK1, kK2 };
  static constexpr int kSize = 6;
  Vec<double, kSize> by = Vec<double, kSize>::Zero();  ///< logarithms, px, px, coefficients of the lens
};

CameraParameters changed(const CameraParameters& camera, const CameraChange& change);

/// Centre of a mark's image, px, with its derivatives.
struct Sight {
  Vec<double, 2> pixel;
  Mat<double, 2, 3> by_centre, by_normal;  ///< of the circle, {cam}
  Mat<double, 2, CameraChange::kSize> by_camera;
  Vec<double, 2> by_log_radius;
};

class Eye {
 public:
  Eye(const CameraParameters& camera, const CameraChange& change);

  /// Nothing where no camera sees it whole: behind, edge on, beyond the lens.
  std::optional<Vec<double, 2>> pixel(const vision::Circle<double>& circle) const { return pixel(circle, model_); }
  /// Derivatives, where no formula is plain, are central differences: exact to 1e-5 of themselves, which Gauss-Newton
  /// does not feel.
  std::optional<Sight> see(const vision::Circle<double>& circle) const;

 private:
  using Camera = vision::CameraModel<double>;
  static std::optional<Vec<double, 2>> pixel(const vision::Circle<double>& circle, const Camera& camera);

  Camera model_;
  std::vector<Camera> beside_;  ///< with a little less and more of the lens's two coefficients
};

}  // namespace articam::identify
