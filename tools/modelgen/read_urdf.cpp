#include "tools/modelgen/read_urdf.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <cmath>
#include <cstring>
#include <string_view>

#include "tools/modelgen/parse_number.hpp"

namespace articam::modelgen {
namespace {

using tinyxml2::XMLElement;

struct Refusal {
  std::size_t at{};
  const char* reason{};
};

/// End of the tag at `at`, where `attributes` counts its equal signs; quoted values may hold any sign.
std::size_t skip_tag(std::string_view xml, std::size_t at, int& attributes) {
  char quote = '\0';
  for (; at < xml.size(); ++at) {
    const char c = xml[at];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '=') {
      ++attributes;
    } else if (c == '>') {
      break;
    }
  }
  return at;
}

/// What must not reach the parser: declarations, and tags for which it would take quadratic time (it compares
/// every attribute with all before it).
std::optional<Refusal> find_hostile_markup(std::string_view xml) {
  for (std::size_t at = xml.find('<'); at < xml.size(); at = xml.find('<', at)) {
    const std::string_view rest = xml.substr(at);
    if (rest.starts_with("<!--")) {
      at = xml.find("-->", at + 4);
    } else if (rest.starts_with("<![CDATA[")) {
      at = xml.find("]]>", at + 9);
    } else if (rest.starts_with("<!")) {
      return Refusal{at, "document types and entities are not taken; remove the declaration"};
    } else {
      int attributes = 0;
      const std::size_t end = skip_tag(xml, at, attributes);
      if (attributes > kMaxAttributes) return Refusal{at, "a tag has more than 64 attributes"};
      at = end;
    }
  }
  return std::nullopt;
}

/// Line of the first element nested deeper than kMaxXmlDepth, or 0. The parser itself stops at 100 levels.
int find_too_deep(const XMLElement& element, int depth) {
  if (depth > kMaxXmlDepth) return element.GetLineNum();
  for (auto child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    if (const int line = find_too_deep(*child, depth + 1); line > 0) return line;
  }
  return 0;
}

std::optional<JointType> joint_type(std::string_view word) {
  if (word == "revolute") return JointType::revolute;
  if (word == "continuous") return JointType::continuous;
  if (word == "prismatic") return JointType::prismatic;
  if (word == "fixed") return JointType::fixed;
  if (word == "planar") return JointType::planar;
  if (word == "floating") return JointType::floating;
  return std::nullopt;
}

/// Reads one <link> or <joint> and reports under its name.
class ElementReader {
 public:
  ElementReader(const std::string& file, Diagnostics& diagnostics, const XMLElement& element)
      : file_{file}, diagnostics_{diagnostics}, element_{element} {
    const char* const name = element.Attribute("name");
    title_ = fmt::format("{} '{}'", element.Name(), name != nullptr ? name : "");
  }

  std::string required(const XMLElement& part, const char* attribute) {
    const char* const text = part.Attribute(attribute);
    if (text != nullptr && *text != '\0') return text;
    error(part, fmt::format("attribute {} is missing", attribute));
    return "";
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
      error(*part, fmt::format("{}=\"{}\" is not three finite numbers", attribute, text));
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
    if (!number) error(part, fmt::format("{}=\"{}\" is not a finite number", attribute, text));
    out = number.value_or(0.0);
    return true;
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
    reader.error(element, fmt::format("type '{}' is none of revolute, continuous, prismatic, fixed", word));
  }
  joint.parent = read_end(reader, element, "parent", joint.parent_line);
  joint.child = read_end(reader, element, "child", joint.child_line);

  const XMLElement* const origin = reader.part("origin");
  reader.vector(origin, "xyz", joint.origin_xyz);
  reader.vector(origin, "rpy", joint.origin_rpy);
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
    joint.mimics = true;
    joint.mimic_line = mimic->GetLineNum();
  }
  return joint;
}

/// The <robot> element, or null after having said what is wrong with the document.
const XMLElement* find_robot(tinyxml2::XMLDocument& document, const SourceFile& source, Diagnostics& diagnostics) {
  const auto refuse = [&](int line, const char* element, const std::string& reason) {
    diagnostics.error(source.path, line, element, reason);
    return nullptr;
  };
  if (const auto hostile = find_hostile_markup(source.bytes)) {
    return refuse(source.line_of(hostile->at), "document", hostile->reason);
  }
  if (document.Parse(source.bytes.data(), source.bytes.size()) == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    return refuse(document.ErrorLineNum(), "document", "elements are nested deeper than 32 levels");
  }
  if (document.Error()) {
    return refuse(document.ErrorLineNum(), "document", fmt::format("not well-formed XML ({})", document.ErrorName()));
  }
  const XMLElement* const robot = document.RootElement();
  if (robot == nullptr || std::strcmp(robot->Name(), "robot") != 0) {
    return refuse(robot != nullptr ? robot->GetLineNum() : 1, "document", "the outermost element is not <robot>");
  }
  if (const XMLElement* const second = robot->NextSiblingElement(); second != nullptr) {
    return refuse(second->GetLineNum(), "document", "a second outermost element; one file holds one robot");
  }
  if (const int line = find_too_deep(*robot, 1); line > 0) {
    return refuse(line, "document", "elements are nested deeper than 32 levels");
  }
  return robot;
}

}  // namespace

std::optional<UrdfModel> read_urdf(const SourceFile& source, Diagnostics& diagnostics) {
  tinyxml2::XMLDocument document;
  const XMLElement* const robot = find_robot(document, source, diagnostics);
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
      diagnostics.warning(source.path, element->GetLineNum(), element->Name(), "a macro left over, ignored; run xacro");
    }
    if (model.links.size() > kMaxLinks || model.joints.size() > kMaxLinks) {
      diagnostics.error(source.path, element->GetLineNum(), "robot", "more than 256 links or joints");
      return std::nullopt;
    }
  }
  return model;
}

}  // namespace articam::modelgen
