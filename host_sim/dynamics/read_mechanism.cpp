#include "host_sim/dynamics/read_mechanism.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>

namespace articam::sim {
namespace {

using tinyxml2::XMLElement;

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument("URDF: " + why); }

std::string text_of(const XMLElement* element, const char* attribute) {
  const char* text = element == nullptr ? nullptr : element->Attribute(attribute);
  return text == nullptr ? "" : text;
}

/// As many numbers as asked for, or the default where the attribute is absent. Whatever the locale.
template <std::size_t N>
std::array<double, N> numbers(const XMLElement* element, const char* attribute, const std::array<double, N>& absent) {
  const std::string text = text_of(element, attribute);
  if (text.empty()) return absent;
  std::array<double, N> values{};
  const char *at = text.data(), *const end = at + text.size();
  for (double& value : values) {
    while (at != end && *at == ' ') ++at;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc{}) refuse(fmt::format("{}=\"{}\" holds no {} numbers", attribute, text, N));
    at = next;
  }
  return values;
}

double number(const XMLElement* element, const char* attribute, double absent) {
  return numbers<1>(element, attribute, {absent})[0];
}

Vec<double, 3> vector_of(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// Roll about x, then pitch about y, then yaw about z, all about fixed axes.
Pose<double> origin_of(const XMLElement* parent) {
  const XMLElement* origin = parent->FirstChildElement("origin");
  const auto rpy = numbers<3>(origin, "rpy", {});
  return {math::exp_so3<double>({0, 0, rpy[2]}) * math::exp_so3<double>({0, rpy[1], 0}) *
              math::exp_so3<double>({rpy[0], 0, 0}),
          vector_of(numbers<3>(origin, "xyz", {}))};
}

/// Of a link, in its own frame.
Mat6 inertia_of(const XMLElement* link) {
  const XMLElement* inertial = link->FirstChildElement("inertial");
  if (inertial == nullptr) return Mat6::Zero();
  const Pose<double> T_link_centre = origin_of(inertial);
  const XMLElement* i = inertial->FirstChildElement("inertia");
  const double xy = number(i, "ixy", 0), xz = number(i, "ixz", 0), yz = number(i, "iyz", 0);
  Mat<double, 3, 3> tensor;
  tensor << number(i, "ixx", 0), xy, xz, xy, number(i, "iyy", 0), yz, xz, yz, number(i, "izz", 0);
  const Mat<double, 3, 3> R = T_link_centre.R.toRotationMatrix();
  return spatial_inertia(number(inertial->FirstChildElement("mass"), "value", 0), T_link_centre.t,
                         R * tensor * R.transpose());
}

/// The inertia of something that is written in {link}, about the body's origin and in its axes.
Mat6 moved(const Mat6& inertia, const Pose<double>& T_body_link) {
  Mat6 to_link = Mat6::Zero();  // a twist about the body's origin -> the same twist about the link's, in its axes
  const Mat<double, 3, 3> R_t = T_body_link.R.toRotationMatrix().transpose();
  to_link.topLeftCorner<3, 3>() = R_t;
  to_link.topRightCorner<3, 3>() = -R_t * math::hat<double>(T_body_link.t);
  to_link.bottomRightCorner<3, 3>() = R_t;
  return to_link.transpose() * inertia * to_link;
}

class Reader {
 public:
  Reader(std::string_view urdf, const std::map<std::string, double>& held) : held_{held} {
    if (document_.Parse(urdf.data(), urdf.size()) != tinyxml2::XML_SUCCESS) refuse(document_.ErrorStr());
    robot_ = document_.FirstChildElement("robot");
    if (robot_ == nullptr) refuse("no <robot>");
  }

  Mechanism read() {
    std::set<std::string> children;
    for (const XMLElement* joint : each("joint")) children.insert(text_of(joint->FirstChildElement("child"), "link"));
    for (const XMLElement* link : each("link")) {
      const std::string name = text_of(link, "name");
      if (children.contains(name)) continue;
      if (!mechanism_.links.empty()) refuse("two roots: " + mechanism_.links.front().name + " and " + name);
      descend(name, -1, {});
    }
    for (const auto& [name, value] : held_) joint_element(name);
    connect_mimics();
    return std::move(mechanism_);
  }

 private:
  std::vector<const XMLElement*> each(const char* kind) const {
    std::vector<const XMLElement*> all;
    const XMLElement* element = robot_->FirstChildElement(kind);
    for (; element != nullptr; element = element->NextSiblingElement(kind)) all.push_back(element);
    return all;
  }

  const XMLElement* joint_element(const std::string& name) const {
    for (const XMLElement* joint : each("joint")) {
      if (text_of(joint, "name") == name) return joint;
    }
    refuse("no joint " + name);
  }

  /// A link fixed to a body, and all below it.
  void descend(const std::string& name, int body, const Pose<double>& T_body_link) {
    mechanism_.links.push_back({name, body, T_body_link});
    for (const XMLElement* link : each("link")) {
      if (text_of(link, "name") != name || body < 0) continue;
      mechanism_.joints[static_cast<std::size_t>(body)].inertia += moved(inertia_of(link), T_body_link);
    }
    for (const XMLElement* joint : each("joint")) {
      if (text_of(joint->FirstChildElement("parent"), "link") != name) continue;
      const std::string child = text_of(joint->FirstChildElement("child"), "link");
      const Pose<double> T_body_joint = T_body_link * origin_of(joint);
      const auto stands_at = standing(joint);
      if (stands_at) {
        descend(child, body, T_body_joint * displacement(joint, *stands_at));
      } else {
        add(joint, body, T_body_joint);
        descend(child, static_cast<int>(mechanism_.joints.size()) - 1, {});
      }
    }
  }

  /// Where a joint stands that does not move.
  std::optional<double> standing(const XMLElement* joint) const {
    if (text_of(joint, "type") == "fixed") return 0;
    if (const auto held = held_.find(text_of(joint, "name")); held != held_.end()) return held->second;
    const XMLElement* mimic = joint->FirstChildElement("mimic");
    if (mimic == nullptr) return std::nullopt;
    const auto leader = standing(joint_element(text_of(mimic, "joint")));
    if (!leader) return std::nullopt;
    return number(mimic, "multiplier", 1) * *leader + number(mimic, "offset", 0);
  }

  static Vec<double, 3> axis_of(const XMLElement* joint) {
    return vector_of(numbers<3>(joint->FirstChildElement("axis"), "xyz", {1, 0, 0})).normalized();
  }

  static Pose<double> displacement(const XMLElement* joint, double q) {
    if (text_of(joint, "type") == "prismatic") return {Quat<double>::Identity(), axis_of(joint) * q};
    return {math::exp_so3<double>(axis_of(joint) * q), Vec<double, 3>::Zero()};
  }

  void add(const XMLElement* element, int parent, const Pose<double>& T_parent_joint) {
    using enum model::JointKind;
    static const std::map<std::string, model::JointKind> kKinds{
        {"revolute", revolute}, {"continuous", continuous}, {"prismatic", prismatic}};
    const auto kind = kKinds.find(text_of(element, "type"));
    if (kind == kKinds.end()) refuse("joint " + text_of(element, "name") + " is neither of one axis nor fixed");
    MechanismJoint joint;
    joint.name = text_of(element, "name");
    joint.kind = kind->second;
    joint.parent = parent;
    joint.axis = axis_of(element);
    joint.T_parent_joint = T_parent_joint;
    const XMLElement* limit = element->FirstChildElement("limit");
    if (limit != nullptr && joint.kind != continuous) {
      joint.q_min = number(limit, "lower", 0);
      joint.q_max = number(limit, "upper", 0);
    }
    const double max_rate = number(limit, "velocity", 0);
    if (max_rate > 0) joint.max_rate = max_rate;
    joint.max_effort = number(limit, "effort", 0);
    const XMLElement* dynamics = element->FirstChildElement("dynamics");
    joint.damping = number(dynamics, "damping", 0);
    joint.friction = number(dynamics, "friction", 0);
    joint.rotor_inertia = number(dynamics, "armature", 0);
    if (mechanism_.joints.size() == static_cast<std::size_t>(kMaxJoints)) refuse("more joints than are simulated");
    mechanism_.joints.push_back(std::move(joint));
  }

  std::size_t row_of(const std::string& name) const {
    std::size_t row = 0;
    while (row < mechanism_.joints.size() && mechanism_.joints[row].name != name) ++row;
    if (row == mechanism_.joints.size()) refuse("no moving joint " + name);
    return row;
  }

  /// Values in the order of the joints that have one of their own.
  void connect_mimics() {
    for (std::size_t row = 0; row < mechanism_.joints.size(); ++row) {
      MechanismJoint& joint = mechanism_.joints[row];
      if (joint_element(joint.name)->FirstChildElement("mimic") != nullptr) continue;
      joint.value = mechanism_.num_values();
      mechanism_.value_rows.push_back(static_cast<int>(row));
    }
    for (MechanismJoint& joint : mechanism_.joints) {
      const XMLElement* mimic = joint_element(joint.name)->FirstChildElement("mimic");
      if (mimic == nullptr) continue;
      const MechanismJoint& leader = mechanism_.joints[row_of(text_of(mimic, "joint"))];
      if (joint_element(leader.name)->FirstChildElement("mimic") != nullptr) refuse(leader.name + " mimics and leads");
      joint.value = leader.value;
      joint.ratio = number(mimic, "multiplier", 1);
      joint.offset = number(mimic, "offset", 0);
    }
  }

  const std::map<std::string, double>& held_;
  tinyxml2::XMLDocument document_;
  const XMLElement* robot_{};
  Mechanism mechanism_;
};

}  // namespace

const MechanismLink& Mechanism::link(std::string_view name) const {
  for (const MechanismLink& link : links) {
    if (link.name == name) return link;
  }
  throw std::invalid_argument(fmt::format("URDF: no link {}", name));
}

Mat6 spatial_inertia(double mass_kg, const Vec<double, 3>& centre_m, const Mat<double, 3, 3>& about_centre) noexcept {
  const Mat<double, 3, 3> mc = math::hat<double>(mass_kg * centre_m);
  Mat6 inertia;
  inertia.topLeftCorner<3, 3>() = mass_kg * Mat<double, 3, 3>::Identity();
  inertia.topRightCorner<3, 3>() = -mc;
  inertia.bottomLeftCorner<3, 3>() = mc;
  inertia.bottomRightCorner<3, 3>() = about_centre - mc * math::hat<double>(centre_m);
  return inertia;
}

Mechanism read_mechanism(std::string_view urdf, const std::map<std::string, double>& held) {
  return Reader{urdf, held}.read();
}

}  // namespace articam::sim
