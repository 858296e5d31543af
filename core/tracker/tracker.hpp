#pragma once
/// @file  The front door: one image in, one estimate out.

#include <span>

#include "core/tracker/acquire.hpp"
#include "core/tracker/associate.hpp"
#include "core/tracker/consensus.hpp"
#include "core/tracker/estimate.hpp"
#include "core/tracker/judge.hpp"
#include "core/tracker/motion_prior.hpp"
#include "core/tracker/noise_scale.hpp"
#include "core/tracker/options.hpp"
#include "core/tracker/paper_law.hpp"
#include "core/tracker/rival.hpp"
#include "core/vision/detector.hpp"

namespace articam::tracker {

/// Follows one object with one camera. Fixed size, no heap, not even in the constructor.
///
/// Without a start (q0 compiled into the model, or set_start) it finds the object by itself: `initialising` until one
/// configuration explains a frame and no other does. Where two do, the reason is `ambiguous`, and candidates() has
/// both; a start, or where the object was last seen, decides. The paper's mode needs a start: no_start without one.
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

  /// Image at its mid-exposure time t -> estimate. A frame that is not later than the last one, or not of the camera
  /// file's size, is refused: coast(t) with that reason, nothing changed.
  EstimateType step(const ImageView& image, Timestamp t) noexcept;

  /// The same from the detections of a frame that an earlier run saw: what they were made from is not looked at again.
  EstimateType step(const vision::Detections& detections, const ImageReport& image, Timestamp t) noexcept;

  /// The estimate at a time at which the camera gave nothing, or nothing that can be used. Changes nothing.
  EstimateType coast(Timestamp t, Reason reason = Reason::no_frame) const noexcept;

  /// The newest estimate, carried on to t by its rates: a controller's time is later than the camera's. What has grown
  /// older than a prediction is worth (Options::coast_time_s) is what coast(t) gives. The past is not predicted: for a
  /// t before it, the newest estimate itself. Changes nothing.
  EstimateType predict(Timestamp t) const noexcept;

  const vision::Detections& detections() const noexcept { return detections_; }
  const ImageReport& image_report() const noexcept { return evidence_.image; }  ///< of the newest frame
  const Matches<Model, Scalar>& matches() const noexcept { return matches_; }
  /// What the newest search without a prediction has found, the likeliest first. After `ambiguous`, both.
  const FixedVector<Hypothesis<Model, Scalar>, 2>& candidates() const noexcept {
    return acquisition_.result().candidates;
  }
  const vision::CameraModel<Scalar>& camera() const noexcept { return camera_; }
  const Options& options() const noexcept { return options_; }

 private:
  static constexpr int kDof = model::kDof<Model>;
  static_assert(model::kNumMarkers<Model> <= static_cast<int>(kMaxDetections), "one detection for each marker");
  static constexpr int kMaxIterations = 12;
  static constexpr int kSearchRounds = 4;        ///< pairings tried in one frame while q0 is being improved
  static constexpr double kPaperMaxRms_px = 20;  ///< the paper's law lags by many pixels and knows no residual

  Reason refusal(Timestamp t) const noexcept;
  bool fits(const ImageView& image) const noexcept;
  EstimateType follow(Timestamp t) noexcept;
  void begin(Timestamp t) noexcept;
  void expect(const Mat<Scalar, kDof, kDof>& P) noexcept;
  void look(const ImageView& image) noexcept;
  void match() noexcept;
  void undo_delays() noexcept;
  void iterate() noexcept;
  void doubt() noexcept;
  void search() noexcept;
  void acquire() noexcept;
  bool is_found() const noexcept;
  void settle(const Configuration& q) noexcept;
  void paper_step() noexcept;
  void filter_feature_rates() noexcept;
  void weigh() noexcept;
  void learn_noise() noexcept;
  EstimateType judge(Timestamp t) noexcept;
  Scalar rms_px() const noexcept;
  FeatureKind feature_kind() const noexcept {
    return options_.mode == Mode::paper ? FeatureKind::point : FeatureKind::imaged_circle;
  }

  Options options_;
  vision::CameraModel<Scalar> camera_;
  vision::Detector detector_;
  Vec<Scalar, kDof> coarse_;  ///< variances that an observation has to beat
  Judge judge_;
  MotionPrior<Model, Scalar> motion_;
  PaperIntegrator<Model, Scalar> paper_;
  Acquisition<Model, Scalar> acquisition_;
  Rival<Model, Scalar> rival_{};
  NoiseScale<Scalar> noise_{}, shape_noise_{};
  bool has_start_{false};  ///< a place to search from first: given, or where the object was last seen
  bool any_frame_{false};
  Timestamp t_frame_{};  ///< of the last frame that was not refused
  EstimateType newest_{};

  // Buffers of one frame.
  bool following_{};  ///< there is a recent estimate; otherwise the whole frame is searched
  Configuration q_{};
  Vec<Scalar, kDof> paper_rates_ = Vec<Scalar, kDof>::Zero();  ///< of the paper's last step
  Vec<Scalar, System<Model, Scalar>::kRows> s_star_dot_ = Vec<Scalar, System<Model, Scalar>::kRows>::Zero();
  Scalar period_s_{};
  Scalar rms_px_{};
  vision::Detections detections_{};
  Features<Model, Scalar> features_{};
  Matches<Model, Scalar> measured_{};  ///< all that were paired
  Matches<Model, Scalar> matches_{};   ///< what of them is believed
  Matches<Model, Scalar> previous_matches_{};
  Consensus<Model, Scalar> found_{};
  Evidence evidence_{};
  std::array<Observability, static_cast<std::size_t>(kDof)> observability_{};
};

}  // namespace articam::tracker

#include "core/tracker/tracker_impl.hpp"
