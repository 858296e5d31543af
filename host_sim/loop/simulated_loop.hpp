#pragma once
/// @file  A scenario around the firmware's loop, from exposure to estimate, and to what the robot makes of it.

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/tracker/options.hpp"
#include "hal/run_loop.hpp"
#include "host_sim/dynamics/read_mechanism.hpp"
#include "host_sim/dynamics/urdf_texts.hpp"
#include "host_sim/loop/eye_tracker.hpp"
#include "host_sim/loop/scene_faults.hpp"
#include "host_sim/ports/keeping_camera.hpp"
#include "host_sim/ports/recording_link.hpp"
#include "host_sim/report/scenario_run.hpp"
#include "host_sim/world/seen_marks.hpp"

namespace articam::sim {

/// By what the controller goes.
enum class Feedback {
  standard,  ///< the tracker's default mode
  paper,     ///< its mode of the paper
  svd,       ///< the baseline of equation (7); it knows no velocity
  truth,     ///< the object itself, at once
};

struct LoopOptions {
  Feedback feedback{Feedback::standard};
  bool rendered{true};     ///< false: detections with a detector's noise, without images
  bool with_rival{false};  ///< the tracker's other mode takes the same marks and is recorded beside it
  double duration_s{};
  double rate_hz{30};
  RenderOptions rendering;  ///< its seed is that of everything
};

/// Where an observer may look on.
template <class Estimate>
struct LoopObservers {
  KeepingCamera<SimCamera>::Keep keep;              ///< each frame
  std::function<Status(const Estimate&)> estimate;  ///< what the loop gave out
  std::function<void(std::size_t frames)> progress;
};

struct LoopRun {
  RunRecord record;                 ///< of a soak the newest frame only
  std::array<long, 6> by_status{};  ///< estimates, in the order of TrackingStatus
  std::vector<ControlSample> samples;
  hal::Counters counters;
  int control_failures{};
  std::string problem;  ///< empty where the run came to its end
};

/// One run: everything that moves, and the loop that looks at it.
template <class Tracker>
class SimulatedLoop {
 public:
  using Model = typename Tracker::ModelType;
  using EstimateType = typename Tracker::EstimateType;
  using Observers = LoopObservers<EstimateType>;

  SimulatedLoop(const Scenario<Model>& scenario, const LoopOptions& options, Observers observers)
      : scenario_{scenario},
        options_{options},
        observers_{std::move(observers)},
        tracker_{std::make_unique<Tracker>(scenario.camera, tracker_options(options))},
        lens_{scenario.camera},
        dice_{options.rendering.seed} {
    if (options.with_rival) {
      tracker::Options rival;
      rival.mode = options.feedback == Feedback::paper ? tracker::Mode::standard : tracker::Mode::paper;
      rival_ = std::make_unique<Tracker>(scenario.camera, rival);
    }
    if (!scenario_.pull) return;
    const Pull& pull = *scenario_.pull;
    WorldOptions world = pull.world;
    world.seed = options.rendering.seed;
    const auto eye = options.feedback == Feedback::truth ? Manipulation::Eye::truth : Manipulation::Eye::sightings;
    robot_.emplace(setting(pull, scenario.rest), world, pull.control, pull.commands, eye);
  }

  LoopRun run() {
    LoopRun result;
    result.record = describe(scenario_, name(options_.feedback), options_.rendering);
    result.record.rendered = options_.rendered;
    if (rival_) result.record.rival_mode = options_.feedback == Feedback::paper ? "default" : "paper";
    SimCamera sim_camera{[this](double t_s, std::uint32_t k) { return expose(t_s, k); }, clock_, camera_options()};
    KeepingCamera<SimCamera> camera{sim_camera, observers_.keep};
    EyeTracker<Tracker> eye{*tracker_, rival_.get(), seen_};
    Link link{*this, {*tracker_, [this](double t_s) { return object_at(t_s); }, result.record}, eye, result};
    const std::chrono::nanoseconds period{static_cast<std::int64_t>(1e9 / options_.rate_hz)};
    hal::RunLoop loop{camera, clock_, link, eye, hal::LoopTimes{.period = period}};
    if (loop.start() != Status::ok) return failed(std::move(result), "the simulated camera does not start");
    for (hal::Tick tick = loop.run_once(); tick != hal::Tick::ended; tick = loop.run_once()) {
      if (loop.counters().link_errors > 0) return failed(std::move(result), "an estimate could not be kept");
      if (!camera.problem().empty()) return failed(std::move(result), camera.problem());
      if (observers_.progress) observers_.progress(static_cast<std::size_t>(loop.counters().frames));
    }
    result.counters = loop.counters();
    if (robot_) {
      result.samples = robot_->samples();
      result.control_failures = robot_->controller().failures();
    }
    return result;
  }

  static const char* name(Feedback feedback) noexcept {
    constexpr const char* kNames[]{"default", "paper", "svd", "truth"};
    return kNames[static_cast<int>(feedback)];
  }

  const CameraParameters& camera() const noexcept { return scenario_.camera; }

  /// What the camera saw in that frame, pixel by pixel; where no images were rendered, what it would have seen. Until
  /// the next.
  ImageView image_of(const FrameRecord& frame) { return photograph(scenes_[frame.frame], frame.frame); }

 private:
  /// What a frame showed.
  struct Scene {
    double t_s{};
    std::vector<SceneMarker> markers;
    std::vector<Limb> limbs;
  };

  /// Records what goes out, and tells the controller what it may know of it.
  struct Link {
    SimulatedLoop& loop;
    RecordingLink<Tracker> memory;
    const EyeTracker<Tracker>& eye;
    LoopRun& run;

    Status publish(const EstimateType& estimate) noexcept {
      loop.advance();
      std::vector<FrameRecord>& frames = run.record.frames;
      if (loop.scenario_.for_soaking) frames.clear();
      const Status recorded = memory.publish(estimate);
      if (recorded != Status::ok) return recorded;
      ++run.by_status[static_cast<std::size_t>(estimate.status)];
      frames.back().step_s = eye.step_s();
      if (const EstimateType& rival = eye.rival_estimate(); rival.valid) {
        frames.back().rival = plain(rival.q);
        frames.back().rival_error_norm = static_cast<double>(rival.error_norm);
      }
      if (loop.robot_) frames.back().wanted = loop.robot_->wanted_at(frames.back().t_s);
      loop.tell(estimate, frames.back());
      return loop.observers_.estimate ? loop.observers_.estimate(estimate) : Status::ok;
    }
  };

  static LoopRun failed(LoopRun&& run, const std::string& why) {
    run.problem = why;
    return std::move(run);
  }

  static tracker::Options tracker_options(const LoopOptions& options) {
    tracker::Options tracking;
    if (options.feedback == Feedback::paper) tracking.mode = tracker::Mode::paper;
    return tracking;
  }

  static Setting setting(const Pull& pull, const ObjectState<Model>& rest) {
    std::map<std::string, double> held;
    for (int j = 0; j < model::kNumJoints<Model>; ++j) {
      const std::string_view joint = model::kValueRows<Model>[static_cast<std::size_t>(j)].name;
      if (j != pull.joint) held.emplace(joint, rest.q.joints[j]);
    }
    return make_setting(read_mechanism(urdf::kHumanoidArm), read_mechanism(pull.object_urdf, held),
                        std::string{pull.handle_link}, pull.handle_m, rest.q.joints[pull.joint],
                        Eigen::Map<const Vec<double, 7>>{pull.posture.data()}, Quat<double>{pull.R_obj_base},
                        rest.q.T_cam_obj);
  }

  SimCamera::Options camera_options() const {
    SimCamera::Options camera;
    camera.rate_hz = options_.rate_hz;
    camera.num_frames = static_cast<std::uint32_t>(options_.duration_s * options_.rate_hz + 0.5);
    camera.fate = [this](std::uint32_t k) {
      return fate_of(scenario_.faults, k / options_.rate_hz, k, options_.rendering.seed);
    };
    camera.unplugged = [this](double t_s) { return fault_at(scenario_.faults, FaultKind::unplugged, t_s, -1) >= 0; };
    return camera;
  }

  /// Robot and controller go on to the clock's now.
  void advance() {
    if (!robot_) return;
    const double now_s = seconds_between({}, clock_.now());
    robot_->world().set_friction_factor(
        fault_at(scenario_.faults, FaultKind::friction, now_s, scenario_.pull->world.friction_factor));
    robot_->advance_to(now_s);
  }

  ObjectState<Model> object_at(double t_s) const {
    if (!robot_) return scenario_.motion(t_s);
    const int joint = scenario_.pull->joint;
    const Manipulation::Instant instant = robot_->at(t_s);
    ObjectState<Model> object = scenario_.rest;
    object.q.T_cam_obj = instant.T_cam_obj;
    object.q.joints[joint] = instant.position;
    object.qdot.template head<6>() = instant.twist;
    object.qdot[6 + joint] = instant.rate;
    return object;
  }

  Scene scene_at(double t_s) const {
    Scene scene{t_s, scene_markers<Model>(object_at(t_s)), {}};
    apply(scenario_.faults, t_s, scene.markers);
    if (robot_) scene.limbs = limbs_of(robot_->at(t_s).arm_cam);
    return scene;
  }

  /// The frame arrives now; it shows what was at t_s.
  ImageView expose(double t_s, std::uint32_t k) {
    advance();
    Scene& scene = scenes_[scenario_.for_soaking ? 0 : k];
    scene = scene_at(t_s);
    if (options_.rendered) return cut(scenario_.faults, t_s, k, photograph(scene, k));
    see_marks(scene.markers, scene.limbs, lens_, options_.rendering.noise_grey, dice_, seen_);
    return {};
  }

  ImageView photograph(const Scene& scene, std::uint32_t k) {
    const RenderOptions at = rendering_at(scenario_.faults, scene.t_s, options_.rendering);
    auto& renderer = renderers_[at.blur_px];
    if (!renderer) renderer = std::make_unique<Renderer>(scenario_.camera, at);
    renderer->set_exposure(at.exposure);
    renderer->render(scene.markers, k, pixels_, scene.limbs);
    const CameraParameters& camera = scenario_.camera;
    return {pixels_.data(), camera.width_px, camera.height_px, camera.width_px};
  }

  void tell(const EstimateType& estimate, const FrameRecord& frame) noexcept {
    using tracker::Reason;
    if (!robot_) return;
    // What was only predicted is no news: the controller predicts for itself.
    if (estimate.status == tracker::TrackingStatus::coasting || estimate.reason == Reason::camera_stalled) return;
    const int joint = scenario_.pull->joint;
    const double t_s = seconds_between({}, estimate.t_capture);
    if (options_.feedback == Feedback::svd) {
      if (frame.svd) robot_->see({t_s, frame.svd->joints[static_cast<std::size_t>(joint)], 0});
      return;
    }
    const bool held = estimate.observability[static_cast<std::size_t>(6 + joint)] == tracker::Observability::held;
    if (!estimate.valid || held) return;
    robot_->see({t_s, static_cast<double>(estimate.q.joints[joint]), static_cast<double>(estimate.qdot[6 + joint])});
  }

  Scenario<Model> scenario_;
  LoopOptions options_;
  Observers observers_;
  std::optional<Manipulation> robot_;
  SimClock clock_;
  std::unique_ptr<Tracker> tracker_, rival_;
  vision::CameraModel<double> lens_;
  Dice dice_;
  vision::Detections seen_{};
  std::map<std::uint32_t, Scene> scenes_;                  ///< of every frame; of a soak the newest
  std::map<double, std::unique_ptr<Renderer>> renderers_;  ///< by the blur of the lens
  std::vector<std::uint8_t> pixels_;
};

}  // namespace articam::sim
