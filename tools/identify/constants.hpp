#pragma once
/// @file  The unknowns that all moments share, and where each stands among them.

#include "tools/identify/eye.hpp"
#include "tools/identify/object.hpp"

namespace articam::identify {

/// What is asked for. The camera's calibration is always open, so that it spoils no length in silence.
struct Request {
  std::vector<int> still;  ///< joint values that are one number each, in rising order
  bool places{};           ///< also every marker's place on its body
};

/// In this order: values of the still joints; how far each marker is displaced on its body (m); the camera; the common
/// logarithm of the marks' radii, since one printer may have scaled them all.
class Constants {
 public:
  Constants(const Object& object, const Request& request)
      : still_{request.still}, num_places_{request.places ? 3 * object.num_markers() : 0} {
    of_value_.assign(static_cast<std::size_t>(object.num_values()), -1);
    moving_ = of_value_;
    for (std::size_t i = 0; i < still_.size(); ++i)
      of_value_[static_cast<std::size_t>(still_[i])] = static_cast<int>(i);
    int next = 0;
    for (std::size_t j = 0; j < of_value_.size(); ++j) moving_[j] = of_value_[j] < 0 ? next++ : -1;
    num_moving_ = next;
  }

  const std::vector<int>& still() const { return still_; }
  int num_moving() const { return num_moving_; }
  /// Index among the constants, or among the moving joints of a moment; -1 where it is the other.
  int of_value(int value) const { return of_value_[static_cast<std::size_t>(value)]; }
  int moving(int value) const { return moving_[static_cast<std::size_t>(value)]; }

  int num_still() const { return static_cast<int>(still_.size()); }
  int num_places() const { return num_places_; }
  int places() const { return num_still(); }
  int camera() const { return places() + num_places_; }
  int radius() const { return camera() + CameraChange::kSize; }
  int size() const { return radius() + 1; }

  CameraChange change(const VectorXd& x) const { return {x.segment<CameraChange::kSize>(camera())}; }

 private:
  std::vector<int> still_;
  int num_places_;
  int num_moving_{};
  std::vector<int> of_value_, moving_;
};

/// What is known of them before anything is seen: a Gaussian about `mean` with that information; 0 is nothing.
struct Prior {
  VectorXd mean, information;
};

/// Of markers' places 10 mm; of the calibration what a careless one misses: 5 % of the focal length, 2 % of the aspect,
/// 5 % of the image's width, 0.3 of each coefficient; of the print's scale 0.5 %.
Prior prior_of(const Constants& constants, const CameraParameters& camera);

}  // namespace articam::identify
