#include "tools/modelgen/parse_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "tools/modelgen/read_urdf.hpp"

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

/// Blanks out `<?...?>`, line ends excepted: they say nothing of a robot, and the parser takes them at the front only.
/// Finds what must not reach the parser: declarations, and tags for which it would take quadratic time (it compares
/// every attribute with all before it).
std::optional<Refusal> prepare_markup(std::string& xml) {
  for (std::size_t at = xml.find('<'); at < xml.size(); at = xml.find('<', at)) {
    const std::string_view rest = std::string_view(xml).substr(at);
    if (rest.starts_with("<!--")) {
      at = xml.find("-->", at + 4);
    } else if (rest.starts_with("<![CDATA[")) {
      at = xml.find("]]>", at + 9);
    } else if (rest.starts_with("<?")) {
      const std::size_t end = std::min(xml.find("?>", at), xml.size() - 2) + 2;
      for (; at < end; ++at) xml[at] = xml[at] == '\n' ? '\n' : ' ';
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

/// What follows the namespace's prefix.
std::string_view local_name(const XMLElement& element) {
  const std::string_view name = element.Name();
  return name.substr(name.rfind(':') + 1);
}

/// <u:robot><u:link/></u:robot> -> <robot><link/></robot>: the root's namespace is that of URDF, whatever its prefix.
void drop_prefix(XMLElement& element, const std::string& prefix) {
  if (std::string_view(element.Name()).starts_with(prefix)) {
    element.SetName(std::string(local_name(element)).c_str());
  }
  for (auto child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    drop_prefix(*child, prefix);
  }
}

const char* what_is_wrong(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "a tag here is not closed, or closed by another name";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "a tag is not finished by >";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not NAME=\"VALUE\", or is given twice";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment is not closed by -->";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "a CDATA section is not closed by ]]>";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "text does not end where a tag should begin";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "there is no element at all";
    default:
      return tinyxml2::XMLDocument::ErrorIDToName(error);
  }
}

}  // namespace

XMLElement* parse_robot(const SourceFile& source, tinyxml2::XMLDocument& document, Diagnostics& diagnostics) {
  const auto refuse = [&](int line, const char* element, const std::string& reason) {
    diagnostics.error(source.path, line, element, reason);
    return static_cast<XMLElement*>(nullptr);
  };
  std::string xml = source.bytes;
  if (const auto hostile = prepare_markup(xml)) {
    return refuse(source.line_of(hostile->at), "document", hostile->reason);
  }
  if (document.Parse(xml.data(), xml.size()) == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    return refuse(document.ErrorLineNum(), "document", "elements are nested deeper than 32 levels");
  }
  if (document.Error()) {
    return refuse(document.ErrorLineNum(), "document",
                  fmt::format("not well-formed XML: {}", what_is_wrong(document.ErrorID())));
  }
  XMLElement* const robot = document.RootElement();
  if (robot == nullptr || local_name(*robot) != "robot") {
    return refuse(robot != nullptr ? robot->GetLineNum() : 1, "document", "the outermost element is not <robot>");
  }
  if (const XMLElement* const second = robot->NextSiblingElement(); second != nullptr) {
    return refuse(second->GetLineNum(), "document", "a second outermost element; one file holds one robot");
  }
  if (const int line = find_too_deep(*robot, 1); line > 0) {
    return refuse(line, "document", "elements are nested deeper than 32 levels");
  }
  const std::string_view name = robot->Name();
  if (name != "robot") drop_prefix(*robot, std::string(name.substr(0, name.size() - 5)));
  return robot;
}

}  // namespace articam::modelgen
