#include "tools/modelgen/resolve_mimics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "core/model/model_table.hpp"

namespace articam::modelgen {
namespace {

class Resolver {
 public:
  Resolver(UrdfModel& model, Diagnostics& diagnostics) : model_{model}, diagnostics_{diagnostics} {
    for (UrdfJoint& joint : model.joints) by_name_.emplace(joint.name, &joint);
  }

  UrdfJoint* find(const std::string& name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : found->second;
  }

  /// The leader becomes one that mimics none. A chain has no more links than the model has joints, or it is a cycle.
  void follow_chain(UrdfJoint& joint) {
    if (!joint.moves()) {
      warning(joint, "<mimic> of a fixed joint is ignored");
      joint.mimics = false;
      return;
    }
    const UrdfJoint* leader = find(joint.leader);
    for (std::size_t step = 0; leader != nullptr && leader->mimics && leader->moves(); ++step) {
      if (leader == &joint || step > model_.joints.size()) {
        return refuse(joint, "the joints that it mimics form a cycle; let one of them move freely");
      }
      joint.offset += joint.ratio * leader->offset;
      joint.ratio *= leader->ratio;
      if (std::abs(joint.ratio) > kMaxCoordinate || std::abs(joint.offset) > kMaxCoordinate) {
        return refuse(joint, "the multipliers or offsets of its chain grow beyond 1e6");
      }
      joint.leader = leader->leader;
      leader = find(joint.leader);
    }
    if (leader == nullptr) {
      const bool has_parts = find(joint.leader + ".x") != nullptr;
      return refuse(joint, fmt::format("mimics joint '{}', which {}", joint.leader,
                                       has_parts ? "has several values; name a part of it, as in NAME.x"
                                                 : "the URDF does not have; correct the name"));
    }
    if (!leader->moves() || leader->held) {
      joint.offset += joint.ratio * leader->held.value_or(0.0);
      hold(joint, fmt::format("mimics joint '{}', which stands still", leader->name));
    } else if (joint.ratio == 0) {
      hold(joint, "mimics by a multiplier of 0");
    }
  }

  void warning(const UrdfJoint& joint, const std::string& reason) {
    diagnostics_.warning(model_.file, joint.mimic_line, title("joint", joint.name), reason);
  }

 private:
  void hold(UrdfJoint& joint, const std::string& why) {
    joint.held = joint.offset;
    joint.mimics = false;
    warning(joint, fmt::format("{}: held at {}", why, joint.offset));
  }

  void refuse(UrdfJoint& joint, const std::string& reason) {
    diagnostics_.error(model_.file, joint.mimic_line, title("joint", joint.name), reason);
  }

  UrdfModel& model_;
  Diagnostics& diagnostics_;
  std::map<std::string, UrdfJoint*> by_name_;
};

void freeze(const Freeze& request, const Resolver& joints, Diagnostics& diagnostics) {
  const std::string name = title("joint", request.joint);
  const auto refuse = [&](const std::string& reason) { diagnostics.error("--freeze", 0, name, reason); };
  UrdfJoint* const joint = joints.find(request.joint);
  if (joint == nullptr) {
    const bool has_parts = joints.find(request.joint + ".x") != nullptr;
    return refuse(has_parts ? "has several values; name a part of it, as in NAME.x" : "the URDF has no such joint");
  }
  if (!joint->moves()) return refuse("is fixed already");
  if (joint->mimics) return refuse(fmt::format("mimics '{}'; freeze that one", joint->leader));
  if (joint->held) return refuse("is given twice, or stands still already");
  if (!(joint->lower <= request.value && request.value <= joint->upper)) {
    diagnostics.warning("--freeze", 0, name, fmt::format("{} is outside its limits", request.value));
  }
  joint->held = request.value;
}

/// The leader goes no further than its follower can; a continuous one says of itself that it turns without end.
void narrow(const UrdfJoint& follower, UrdfJoint& leader, Resolver& joints) {
  if (leader.type == JointType::continuous) return;
  const auto leader_at = [&](double value) {
    return std::abs(value) < model::kUnlimited ? (value - follower.offset) / follower.ratio
                                               : std::copysign(model::kUnlimited, value * follower.ratio);
  };
  const auto rounding = [](double limit) { return 1e-6 * (1 + std::abs(limit)); };  // of a multiplier's digits
  const auto [least, most] = std::minmax({leader_at(follower.lower), leader_at(follower.upper)});
  if (least <= leader.lower + rounding(least) && most >= leader.upper - rounding(most)) return;
  const double lower = std::max(leader.lower, least) + 0.0, upper = std::min(leader.upper, most) + 0.0;  // no -0
  if (!(lower + rounding(lower) < upper)) {
    return joints.warning(
        follower, fmt::format("its limits leave '{}', which it mimics, no room: they are ignored", leader.name));
  }
  leader.lower = lower;
  leader.upper = upper;
  leader.narrowed_by = follower.name;
  joints.warning(follower, fmt::format("its limits hold '{}', which it mimics, between {:.6g} and {:.6g}", leader.name,
                                       lower, upper));
}

}  // namespace

void resolve_mimics(UrdfModel& model, const ModelOptions& options, Diagnostics& diagnostics) {
  Resolver resolver(model, diagnostics);
  for (UrdfJoint& joint : model.joints) {
    if (joint.mimics) resolver.follow_chain(joint);
  }
  for (const Freeze& request : options.freeze) freeze(request, resolver, diagnostics);
  for (UrdfJoint& joint : model.joints) {
    UrdfJoint* const leader = joint.mimics ? resolver.find(joint.leader) : nullptr;
    if (leader == nullptr || leader->mimics) continue;  // refused
    if (!leader->held) {
      narrow(joint, *leader, resolver);
      continue;
    }
    joint.held = joint.ratio * *leader->held + joint.offset;
    joint.mimics = false;
    if (joint.lower <= *joint.held && *joint.held <= joint.upper) continue;
    resolver.warning(joint, fmt::format("held at {} with its leader, outside its limits", *joint.held));
  }
}

}  // namespace articam::modelgen
