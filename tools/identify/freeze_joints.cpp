#include "tools/identify/freeze_joints.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "tools/modelgen/parse_robot.hpp"
#include "tools/modelgen/reduce.hpp"

namespace articam::identify {
namespace {

using modelgen::rounded;
using tinyxml2::XMLElement;

/// Fixed-axis roll, pitch and yaw, R = Rz(y) Ry(p) Rx(r); at a pitch of 90 degrees the roll is 0.
Vec3 roll_pitch_yaw(const Mat3& R) {
  const double level = std::hypot(R(0, 0), R(1, 0));
  const double pitch = std::atan2(-R(2, 0), level);
  if (level < 1e-9) return {0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

/// 12 decimals are a picometre, and what a turn of half a circle leaves is no number to read.
std::string three(const Vec3& v) {
  const auto neat = [](double x) { return std::round(x * 1e12) / 1e12 + 0.0; };
  return fmt::format("{} {} {}", neat(v[0]), neat(v[1]), neat(v[2]));
}

void fix(XMLElement& element, const modelgen::UrdfJoint& joint, double value, const std::string& comment) {
  const bool slides = joint.type == modelgen::JointType::prismatic;
  const Vec3 axis = Vec3(joint.axis[0], joint.axis[1], joint.axis[2]).normalized();
  const Pose<double> T =
      modelgen::pose_of(joint.origin_xyz, joint.origin_rpy) * modelgen::displacement(slides, value * axis);
  const Vec3 rpy = slides ? Vec3(joint.origin_rpy[0], joint.origin_rpy[1], joint.origin_rpy[2])
                          : roll_pitch_yaw(T.R.toRotationMatrix());
  element.SetAttribute("type", "fixed");
  for (const char* const part : {"origin", "axis", "limit", "mimic", "dynamics", "safety_controller", "calibration"}) {
    while (XMLElement* const child = element.FirstChildElement(part)) element.DeleteChild(child);
  }
  element.InsertFirstChild(element.GetDocument()->NewComment(comment.c_str()));
  XMLElement* const origin = element.InsertNewChildElement("origin");
  origin->SetAttribute("xyz", three(T.t).c_str());
  origin->SetAttribute(
      "rpy", slides && rpy == Vec3::Zero() ? "0 0 0" : fmt::format("{} {} {}", rpy[0], rpy[1], rpy[2]).c_str());
}

XMLElement* find_joint(XMLElement& robot, std::string_view name) {
  for (XMLElement* joint = robot.FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint")) {
    const char* const found = joint->Attribute("name");
    if (found != nullptr && name == found) return joint;
  }
  return nullptr;
}

std::string comment_of(const Length& length) {
  const char* const unit = length.slides ? "m" : "rad";
  return fmt::format(" {}: identified as {:.7f} {}, standard deviation {:.7f} {} ", length.joint, length.value, unit,
                     length.deviation, unit);
}

}  // namespace

std::optional<std::string> freeze_joints(const modelgen::SourceFile& source, const modelgen::UrdfModel& model,
                                         const std::vector<Length>& lengths, modelgen::Diagnostics& diagnostics) {
  tinyxml2::XMLDocument document;
  XMLElement* const robot = modelgen::parse_robot(source, document, diagnostics);
  if (robot == nullptr) return std::nullopt;
  for (const Length& length : lengths) {
    for (const modelgen::UrdfJoint& joint : model.joints) {
      const bool follows = joint.mimics && joint.leader == length.joint;
      if (joint.name != length.joint && !follows) continue;
      XMLElement* const element = find_joint(*robot, joint.name);
      if (element == nullptr) {
        diagnostics.error(source.path, joint.line, modelgen::title("joint", joint.name),
                          "is a part of a planar or floating joint, which cannot stand still alone");
        continue;
      }
      if (follows) {
        fix(*element, joint, joint.ratio * length.value + joint.offset,
            fmt::format(" follows {}, which was identified ", length.joint));
      } else {
        fix(*element, joint, length.value, comment_of(length));
      }
    }
  }
  if (diagnostics.has_errors()) return std::nullopt;
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return fmt::format("<?xml version=\"1.0\"?>\n{}", printer.CStr());
}

}  // namespace articam::identify
