#include "tools/modelgen/read_urdf.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <cmath>
#include <string_view>

#include "tools/modelgen/parse_number.hpp"
#include "tools/modelgen/parse_robot.hpp"

namespace articam::modelgen {
namespace {

using tinyxml2::XMLElement;

std::optional<JointType> joint_type(std::string_view word) {
  if (word == "revolute") return JointType::revolute;
  if (word == "continuous") return JointType::continuous;
  if (word == "prismatic") return JointType::prismatic;
  if (word == "fixed") return JointType::fixed;
  if (word == "planar") return JointType::planar;
  if (word == "floating") return JointType::floating;
  return std::nullopt;
}

/// `${...}` and `$(...)` are xacro's, which a person has to run first.
bool is_macro(std::string_view text) { return text.find("${") != text.npos || text.find("$(") != text.npos; }

/// Reads one <link> or <joint> and reports under its name.
class ElementReader {
 public:
  ElementReader(const std::string& file, Diagnostics& diagnostics, const XMLElement& element)
      : file_{file}, diagnostics_{diagnostics}, element_{element} {
    const char* const name = element.Attribute("name");
    title_ = title(element.Name(), name != nullptr ? name : "");
  }

  std::string required(const XMLElement& part, const char* attribute) {
    const char* const text = part.Attribute(attribute);
    if (text == nullptr || *text == '\0') {
      error(part, fmt::format("attribute {} is missing", attribute));
      return "";
    }
    if (is_macro(text)) malformed(part, attribute, text, "a name");
    return text;
  }

  /// The only child of that name; null when there is none.
  const XMLElement* part(const char* name) {
    const XMLElement* const first = element_.FirstChildElement(name);
    const XMLElement* const second = first != nullptr ? first->NextSiblingElement(name) : nullptr;
    if (second != nullptr) error(*second, "is given twice; keep one");
    return first;
  }

  /// The attribute's three numbers, if it is there; the default stays otherwise.
  void vector(const XMLElement* part, const char* attribute, std::array<double, 3>& out) {
    const char* const text = part != nullptr ? part->Attribute(attribute) : nullptr;
    if (text == nullptr) return;
    const auto numbers = parse_numbers(text);
    if (!numbers || numbers->size() != 3) {
      malformed(*part, attribute, text, "three finite numbers");
      return;
    }
    for (const double x : *numbers) {
      if (std::abs(x) > kMaxCoordinate) error(*part, fmt::format("{}=\"{}\" is beyond 1e6", attribute, text));
    }
    out = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  }

  /// Whether the attribute is there.
  bool number(const XMLElement& part, const char* attribute, double& out) {
    const char* const text = part.Attribute(attribute);
    if (text == nullptr) return false;
    const auto number = parse_number(text);
    if (!number) malformed(part, attribute, text, "a finite number");
    out = number.value_or(0.0);
    return true;
  }

  void malformed(const XMLElement& part, const char* attribute, const char* text, const char* wanted) {
    const char* const fix = is_macro(text) ? ", but an expression of xacro; run `xacro FILE.xacro > FILE.urdf`" : "";
    error(part, fmt::format("{}=\"{}\" is not {}{}", attribute, text, wanted, fix));
  }

  void error(const XMLElement& part, std::string reason) {
    const std::string where = &part == &element_ ? title_ : fmt::format("{} <{}>", title_, part.Name());
    diagnostics_.error(file_, part.GetLineNum(), where, std::move(reason));
  }

 private:
  const std::string& file_;
  Diagnostics& diagnostics_;
  const XMLElement& element_;
  std::string title_;
};

std::string read_end(ElementReader& reader, const XMLElement& joint, const char* end, int& line) {
  const XMLElement* const part = reader.part(end);
  if (part == nullptr) {
    reader.error(joint, fmt::format("<{} link=\"...\"/> is missing", end));
    return "";
  }
  line = part->GetLineNum();
  return reader.required(*part, "link");
}

UrdfJoint read_joint(const std::string& file, const XMLElement& element, Diagnostics& diagnostics) {
  ElementReader reader(file, diagnostics, element);
  UrdfJoint joint;
  joint.line = joint.axis_line = element.GetLineNum();
  joint.name = reader.required(element, "name");
  const std::string word = reader.required(element, "type");
  const auto type = joint_type(word);
  if (type) {
    joint.type = *type;
  } else if (!word.empty()) {
    reader.error(element,
                 fmt::format("type '{}' is none of revolute, continuous, prismatic, fixed, planar, floating", word));
  }
  joint.parent = read_end(reader, element, "parent", joint.parent_line);
  joint.child = read_end(reader, element, "child", joint.child_line);

  const XMLElement* const origin = reader.part("origin");
  reader.vector(origin, "xyz", joint.origin_xyz);
  reader.vector(origin, "rpy", joint.origin_rpy);
  if (origin != nullptr && origin->Attribute("quat_xyzw") != nullptr) {
    reader.error(*origin, "quat_xyzw is not read; give the rotation as rpy");
  }
  if (const XMLElement* const axis = reader.part("axis"); axis != nullptr) {
    joint.axis_line = axis->GetLineNum();
    reader.required(*axis, "xyz");
    reader.vector(axis, "xyz", joint.axis);
  }
  if (const XMLElement* const limit = reader.part("limit"); limit != nullptr) {
    joint.limit_line = limit->GetLineNum();
    const bool lower = reader.number(*limit, "lower", joint.lower);
    const bool upper = reader.number(*limit, "upper", joint.upper);
    joint.has_limit = lower || upper;
  }
  if (const XMLElement* const mimic = reader.part("mimic"); mimic != nullptr) {
    joint.mimic_line = mimic->GetLineNum();
    joint.leader = reader.required(*mimic, "joint");
    joint.mimics = !joint.leader.empty();
    reader.number(*mimic, "multiplier", joint.ratio);
    reader.number(*mimic, "offset", joint.offset);
    if (std::abs(joint.ratio) > kMaxCoordinate || std::abs(joint.offset) > kMaxCoordinate) {
      reader.error(*mimic, "multiplier or offset is beyond 1e6");
    }
  }
  return joint;
}

}  // namespace

std::optional<UrdfModel> read_urdf(const SourceFile& source, Diagnostics& diagnostics) {
  tinyxml2::XMLDocument document;
  const XMLElement* const robot = parse_robot(source, document, diagnostics);
  if (robot == nullptr) return std::nullopt;

  UrdfModel model;
  model.file = source.path;
  model.line = robot->GetLineNum();
  if (const char* const name = robot->Attribute("name"); name != nullptr) model.robot = name;
  for (auto element = robot->FirstChildElement(); element != nullptr; element = element->NextSiblingElement()) {
    const std::string_view kind = element->Name();
    if (kind == "link") {
      ElementReader reader(source.path, diagnostics, *element);
      model.links.push_back({reader.required(*element, "name"), element->GetLineNum()});
    } else if (kind == "joint") {
      model.joints.push_back(read_joint(source.path, *element, diagnostics));
    } else if (kind.starts_with("xacro:")) {
      diagnostics.warning(source.path, element->GetLineNum(), element->Name(),
                          "a macro left over, ignored; run `xacro FILE.xacro > FILE.urdf`");
    }
    if (model.links.size() > kMaxLinks || model.joints.size() > kMaxLinks) {
      diagnostics.error(source.path, element->GetLineNum(), "robot", "more than 256 links or joints");
      return std::nullopt;
    }
  }
  model.num_links = model.links.size();
  model.num_joints = model.joints.size();
  return model;
}

}  // namespace articam::modelgen
