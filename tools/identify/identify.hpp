#pragma once
/// @file  A recording -> identified lengths, markers' places, and what it says of the camera's calibration.

#include <optional>
#include <string>
#include <vector>

#include "tools/identify/constants.hpp"
#include "tools/identify/recording.hpp"

namespace articam::identify {

/// A joint that stood still: a constant of the object.
struct Length {
  std::string joint;
  bool slides{};
  double value{}, deviation{};  ///< m or rad
};

struct MarkerPlace {
  std::string marker;
  Vec3 displaced;   ///< m, on its body, from where the model has it
  Mat3 covariance;  ///< m^2
  bool seen{};
  bool reference{};  ///< it stands where the model has it, and holds the frame for the others
};

/// One part of the calibration. Its error is what to add to the camera file's number.
struct Judgement {
  enum class Part { focal_length, aspect, principal_x, principal_y, distortion };
  Part part{};
  double error{}, deviation{};  ///< shares of 1; px for the principal point and for the lens, at the outermost mark
  double effect_px{};           ///< what the error does to a mark near the image's edge
  bool told{};                  ///< the recording says more than a careless calibration knows

  double significance() const;  ///< in deviations
  bool wrong() const;           ///< significant, and worth a new calibration
};

struct Findings {
  std::vector<Length> lengths;
  std::vector<MarkerPlace> places;  ///< of all markers, or none
  std::vector<Judgement> camera;
  int num_held{};  ///< directions of places that no recording tells
  int num_moments{}, num_sightings{}, num_outliers{};
  double rms_px{}, noise{};  ///< noise: over what the detector promises
  bool converged{};
};

inline constexpr std::size_t kLeastMoments = 10, kMostMoments = 300;

/// Nothing where the recording has fewer than kLeastMoments.
std::optional<Findings> identify(const Object& object, const CameraParameters& camera, const Recording& recording,
                                 const Request& request);

}  // namespace articam::identify
