#pragma once
/// @file  How much larger the residuals are than the detector promises, learnt over many frames.

namespace articam::tracker {

/// Factor on the matches' variances. Print, model and calibration are never perfect; one frame's few spare equations
/// cannot tell by how much, a running mean over frames can. Errors that stay the same in all frames, such as a wrong
/// focal length, still move the estimate itself without showing here.
template <class S>
class NoiseScale {
 public:
  /// Never below 1: no surer than the detector.
  S factor() const noexcept { return mean_ > S(1) ? mean_ : S(1); }

  /// A frame's sum of squared normalised distances, under the present factor, and its equations beyond the unknowns.
  void learn(S chi2, int spare_equations) noexcept {
    if (spare_equations <= 0) return;
    const S measured = factor() * chi2 / static_cast<S>(spare_equations);
    frames_ = frames_ < kMemory ? frames_ + 1 : kMemory;
    mean_ += (measured - mean_) / static_cast<S>(frames_ + 1);
  }

 private:
  static constexpr int kMemory = 100;  ///< frames
  static constexpr S kStart{25};       ///< five times the detector's deviation, with the weight of one frame

  S mean_{kStart};
  int frames_{0};
};

}  // namespace articam::tracker
