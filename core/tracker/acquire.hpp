#pragma once
/// @file  The marks of one frame -> the configuration that explains them, without being told where to look.

#include "core/tracker/joint_search.hpp"
#include "core/tracker/mirror_image.hpp"
#include "core/tracker/pair_pose.hpp"
#include "core/tracker/tracking_status.hpp"

namespace articam::tracker {

enum class Certainty : std::uint8_t {
  none,       ///< no configuration explains the frame, or the search goes on in the next one
  ambiguous,  ///< two do, and the frame does not tell which is true
  sure,       ///< one does, and no other
};

/// What a search has found. `candidates` holds the best, then the best distinct one; where nothing is certain they are
/// what came nearest.
template <class M, class S>
struct Acquired {
  Certainty certainty{Certainty::none};
  Reason reason{Reason::few_markers};  ///< why not sure
  bool complete{};                     ///< every hypothesis was looked at, in this frame or those before
  int work{};                          ///< steps spent on this frame, see Acquisition::kBudget
  FixedVector<Hypothesis<M, S>, 2> candidates{};
};

/// Takes pairs of marks for pairs of markers, the surest first; each that agrees in distance and normals gives a pose,
/// which the other markers confirm or refute: those fixed to the pair, then joint by joint those that follow from a
/// joint's value, searched along its travel. What is left is solved for, and weighed by all that it leaves unexplained.
/// A hypothesis is dropped once it can no longer come near the best one, so that finding that early saves most work.
///
/// The work of a frame is bounded (kBudget); where it ends, the next frame goes on with its own marks at the hypothesis
/// after, and what was found is weighed there anew. It needs two markers in view with at most one joint between them.
template <class M, class S>
class Acquisition {
 public:
  using Configuration = model::Configuration<M, S>;

  /// Steps of a frame: one for a solver's iteration or a look at all markers, or for 32 pairs of marks tried. The
  /// hypothesis at which it ends is finished, with the challenge that follows.
  static constexpr int kBudget = 900;

  Acquisition(const vision::CameraModel<S>& camera, S floor_px) noexcept : camera_{camera}, floor_px_{floor_px} {}

  /// Begins, or goes on. `variance_factor` is the noise's scale over what the detector promises.
  const Acquired<M, S>& search(const vision::Detections& detections, S variance_factor) noexcept;
  /// What explains the marks surely better than q, of which it is the mirror image or another value of a joint.
  /// Errors  too_few_features when nothing does.
  Result<Configuration> better_than(const Configuration& q, const vision::Detections& detections,
                                    S variance_factor) noexcept;
  const Acquired<M, S>& result() const noexcept { return result_; }
  const Sightings<M, S>& sightings() const noexcept { return sightings_; }
  void reset() noexcept { result_ = {}, next_ = {}; }

 private:
  /// A hypothesis in the order of the search: a marker pair, where on the travel of the joint between them, the two
  /// marks, and which pose of the first.
  struct Cursor {
    int pass{};  ///< 0: only what explains all that a frame can be asked for; 1: the rest
    std::size_t pair{};
    int piece{};
    std::size_t i{}, j{1}, side{};
  };
  /// A cluster's pose from which everything was tried.
  struct Trial {
    int anchor{};
    Pose<S> T_cam_anchor{};
  };
  static constexpr std::size_t kMaxTrials = 16;
  /// Cost that a distinct hypothesis must have beyond the best: odds of 1 to 3000.
  static constexpr S kMargin{16};
  /// Mean cost of a good pair: 1 for the shape's two axes each, little for the centre, and a third of blur's bias.
  static constexpr S kMaxMisfit{9};
  /// The same with a marker missing: few spare equations are left then, and a mirror image may cost 1 a pair.
  static constexpr S kMaxMisfitOfPart{S(0.6)};
  static constexpr int kIterations = 8;
  static constexpr int kFirstGuesses = -1, kNoJoint = model::kNumJoints<M>;  ///< see develop()
  static constexpr int kNoBlindJoint = -1;
  static constexpr int kFirstIterations = 3;  ///< from two marks: pairs follow that say more

  void try_pairs() noexcept;
  void go_on(const Acquired<M, S>& before) noexcept;
  bool advance() noexcept;
  void consider() noexcept;
  bool place_markers(PlacedMarker<S>& a, PlacedMarker<S>& b, Configuration& q) const noexcept;
  void develop(Configuration q, int anchor, JointSet known, int second_guess) noexcept;
  bool approach(Configuration& q, int anchor, JointSet known, S reach, int iterations, Pairing<M>& pairing) noexcept;
  bool was_tried(const Configuration& q, int anchor) const noexcept;
  void remember(const Configuration& q, int anchor) noexcept;
  int next_joint(int anchor, JointSet known, JointSet tried) const noexcept;
  void weigh(Configuration q, int anchor, JointSet known) noexcept;
  void challenge() noexcept;
  S limit() const noexcept;
  bool is_hopeless(S least) const noexcept;
  void record(const Hypothesis<M, S>& hypothesis) noexcept;
  bool is_credible(const Hypothesis<M, S>& hypothesis) const noexcept;
  void conclude() noexcept;

  vision::CameraModel<S> camera_;
  S floor_px_;
  S variance_factor_{1};
  Cursor next_{};
  int pairs_tried_{};
  std::array<Trial, kMaxTrials> trials_{};  ///< the newest; of a frame
  std::size_t num_trials_{};
  Sightings<M, S> sightings_{};
  Acquired<M, S> result_{};
};

}  // namespace articam::tracker

#include "core/tracker/acquire_impl.hpp"
