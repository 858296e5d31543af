#pragma once
/// @file  How much larger the residuals are than the detector promises, learnt over many frames.

namespace articam::tracker {

/// Factor on the variances of one sort of measurement. Print, model and calibration are never perfect; one frame's few
/// spare equations cannot tell by how much, a running mean over frames can. Errors that stay the same in all frames,
/// such as a wrong focal length, still move the estimate itself without showing here.
template <class S>
class NoiseScale {
 public:
  /// Never below 1: no surer than the detector.
  S factor() const noexcept { return chi2_ > spare_ ? chi2_ / spare_ : S(1); }

  /// A frame's sum of squared normalised distances, under the present factor, and its expectation: equations less the
  /// unknowns that they determine.
  void learn(S chi2, S spare) noexcept {
    if (!(spare > S(0)) || !(chi2 >= S(0))) return;
    chi2_ = kMemory * chi2_ + factor() * chi2;
    spare_ = kMemory * spare_ + spare;
  }

 private:
  static constexpr S kMemory = S(0.99);  ///< 100 frames
  /// Before the first frame: twelve times the detector's deviation, some quarter of a pixel, and a fifth of an equation
  /// soon outvotes it.
  static constexpr S kStart = S(150), kStartEquations = S(0.2);

  S chi2_{kStart * kStartEquations};
  S spare_{kStartEquations};
};

}  // namespace articam::tracker
