#include "host_sim/loop/manipulation.hpp"

#include <algorithm>

namespace articam::sim {
namespace {
constexpr double kDt = WorldOptions::kStep_s;
}

Manipulation::Manipulation(const Setting& setting, const WorldOptions& world, const ControlOptions& control,
                           std::span<const JointCommand> commands, Eye eye)
    : world_{setting, world},
      controller_{setting.robot,       setting.object,  setting.grasp,           setting.T_obj_base,
                  setting.gravity_obj, setting.posture, setting.object_position, control},
      commands_{commands.begin(), commands.end()},
      eye_{eye},
      max_silence_s_{control.max_silence_s},
      steps_per_period_{static_cast<int>(control.period_s / kDt + 0.5)},
      sighting_{-1e9, setting.object_position, 0},
      past_(static_cast<std::size_t>(kMemory_s / kDt) + 2, Past{setting.object_position, 0, world_.arm_cam()}) {}

void Manipulation::advance_to(double t_s) {
  while (static_cast<double>(steps_ + 1) * kDt <= t_s + 1e-9) {
    const long phase = steps_ % steps_per_period_;
    if (phase == 0) control();
    world_.step(controller_.command(), static_cast<double>(phase + 1) * kDt);
    ++steps_;
    past_[static_cast<std::size_t>(steps_) % past_.size()] = {world_.object_position(), world_.object_rate(),
                                                              world_.arm_cam()};
  }
}

std::optional<double> Manipulation::wanted_at(double t_s) const noexcept {
  std::optional<double> target;
  for (const JointCommand& command : commands_) {
    if (command.t_s <= t_s) target = command.target;
  }
  return target;
}

void Manipulation::control() {
  const double now_s = static_cast<double>(steps_) * kDt;
  ControlSample sample;
  sample.t_s = now_s;
  sample.target = sample.position = sample.told = world_.object_position();
  if (const auto wanted = wanted_at(now_s)) {
    JointFeedback feedback{world_.object_position(), 0};
    if (eye_ == Eye::sightings) {
      feedback.age_s = now_s - sighting_.t_s;
      feedback.position = sighting_.position + std::min(feedback.age_s, max_silence_s_) * sighting_.rate;
    }
    sample.target = *wanted;
    sample.told = feedback.position;
    controller_.step(feedback, sample.target);
  }
  sample.hand_velocity = world_.hand_twist().head<3>();
  sample.pull = world_.force().head<3>().norm();
  samples_.push_back(sample);
}

Manipulation::Instant Manipulation::at(double t_s) const noexcept {
  const auto step = std::clamp(static_cast<long>(t_s / kDt + 1e-6), 0L, steps_);
  const Past& past = past_[static_cast<std::size_t>(step) % past_.size()];
  const double since_s = t_s - static_cast<double>(step) * kDt;
  const Pose<double> T = world_.T_cam_obj(t_s), before = world_.T_cam_obj(t_s - kDt),
                     after = world_.T_cam_obj(t_s + kDt);
  Vec6 twist;
  twist << after.t - before.t, math::log_so3<double>(after.R * before.R.conjugate());
  return {past.position + since_s * past.rate, past.rate, T, twist / (2 * kDt), past.arm_cam};
}

}  // namespace articam::sim
