#pragma once
/// @file  The front door: one image in, one estimate out.

#include <span>

#include "core/tracker/associate.hpp"
#include "core/tracker/consensus.hpp"
#include "core/tracker/estimate.hpp"
#include "core/tracker/judge.hpp"
#include "core/tracker/motion_prior.hpp"
#include "core/tracker/options.hpp"
#include "core/tracker/paper_law.hpp"
#include "core/vision/detector.hpp"

namespace articam::tracker {

/// Follows one object with one camera. Fixed size, no heap, not even in the constructor.
///
/// Without a start (q0 compiled into the model, or set_start) every estimate is `initialising`, reason no_start.
template <class Model, class Scalar>
class Tracker {
 public:
  using ModelType = Model;
  using ScalarType = Scalar;
  using Configuration = model::Configuration<Model, Scalar>;
  using EstimateType = Estimate<Model, Scalar>;

  explicit Tracker(const CameraParameters& camera, const Options& options = {}) noexcept;

  /// Where to begin. Forgets what was tracked.
  void set_start(const Configuration& q0) noexcept;

  /// Image at its mid-exposure time t -> estimate. `t` must not be before the last one.
  EstimateType step(const ImageView& image, Timestamp t) noexcept;

  /// The estimate at a time at which the camera gave nothing.
  EstimateType coast(Timestamp t) noexcept;

  const vision::Detections& detections() const noexcept { return detections_; }
  const Matches<Model, Scalar>& matches() const noexcept { return matches_; }
  const vision::CameraModel<Scalar>& camera() const noexcept { return camera_; }
  const Options& options() const noexcept { return options_; }

 private:
  static constexpr int kDof = model::kDof<Model>;
  static constexpr int kMaxIterations = 12;
  static constexpr int kSearchRounds = 4;        ///< pairings tried in one frame while q0 is being improved
  static constexpr int kScaleFrames = 100;       ///< memory of the noise scale
  static constexpr double kPaperMaxRms_px = 20;  ///< the paper's law lags by many pixels and knows no residual
  /// Mean squared normalised distance above which a frame's matches contradict each other.
  static constexpr Scalar kConsistent{9};

  void begin(Timestamp t) noexcept;
  bool fits(const ImageView& image) noexcept;
  void look(const ImageView& image) noexcept;
  void match(const Gate<Scalar>& gate) noexcept;
  void iterate(const Prior<Model, Scalar>& prior) noexcept;
  void search() noexcept;
  void paper_step() noexcept;
  void weigh() noexcept;
  EstimateType judge(const Evidence& evidence, Timestamp t) noexcept;
  Scalar rms_px() const noexcept;

  Options options_;
  vision::CameraModel<Scalar> camera_;
  vision::Detector detector_;
  Judge judge_;
  MotionPrior<Model, Scalar> motion_;
  PaperIntegrator<Model, Scalar> paper_;
  bool has_start_{false};
  Scalar noise_scale_{1};  ///< measured : promised variance of the matches, over many frames
  int frames_in_scale_{0};
  Vec<Scalar, kDof> qdot_ = Vec<Scalar, kDof>::Zero();

  // Buffers of one frame.
  Configuration q_{};
  Scalar period_s_{};
  Scalar rms_px_{};
  vision::Detections detections_{};
  Features<Model, Scalar> features_{};
  Matches<Model, Scalar> matches_{};
  Matches<Model, Scalar> previous_matches_{};
  Consensus<Model, Scalar> found_{};
  Evidence evidence_{};
};

}  // namespace articam::tracker

#include "core/tracker/tracker_impl.hpp"
