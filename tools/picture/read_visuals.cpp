#include "tools/picture/read_visuals.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <map>
#include <optional>

#include "tools/modelgen/parse_number.hpp"
#include "tools/modelgen/parse_robot.hpp"
#include "tools/modelgen/reduce.hpp"

namespace articam::picture {
namespace {

using tinyxml2::XMLElement;

class Reader {
 public:
  Reader(const std::string& file, modelgen::Diagnostics& diagnostics) : file_{file}, diagnostics_{diagnostics} {}

  std::vector<Visual> read(const XMLElement& robot) {
    for_each(robot, "material", [&](const XMLElement& material) { remember(material); });
    std::vector<Visual> visuals;
    for_each(robot, "link", [&](const XMLElement& link) {
      const char* const name = link.Attribute("name");
      for_each(link, "visual", [&](const XMLElement& element) {
        if (auto visual = read_visual(element)) {
          visual->link = name != nullptr ? name : "";
          visuals.push_back(std::move(*visual));
        }
      });
    });
    if (num_left_out_ > 0) {
      diagnostics_.warning(file_, first_left_out_, "<visual>",
                           fmt::format("{} of them not drawn: only boxes, cylinders and spheres are", num_left_out_));
    }
    return visuals;
  }

 private:
  template <class Visit>
  static void for_each(const XMLElement& parent, const char* name, const Visit& visit) {
    for (auto child = parent.FirstChildElement(name); child; child = child->NextSiblingElement(name)) visit(*child);
  }

  /// Exactly N numbers; the default when there is no such attribute.
  template <std::size_t N>
  std::array<double, N> numbers(const XMLElement& element, const char* attribute, std::array<double, N> absent) {
    const char* const text = element.Attribute(attribute);
    if (text == nullptr) return absent;
    const auto values = modelgen::parse_numbers(text);
    if (!values || values->size() != N) {
      diagnostics_.error(file_, element.GetLineNum(), fmt::format("<{}> {}", element.Name(), attribute),
                         fmt::format("expected {} finite numbers", N));
      return absent;
    }
    std::copy_n(values->begin(), N, absent.begin());
    return absent;
  }

  /// A material's colour, by its own element or by one of that name before it.
  std::optional<Colour> remember(const XMLElement& material) {
    const std::string name = material.Attribute("name") != nullptr ? material.Attribute("name") : "";
    if (const XMLElement* const colour = material.FirstChildElement("color")) {
      const auto rgba = numbers<4>(*colour, "rgba", {0.7, 0.7, 0.7, 1});
      colours_[name] = {rgba[0], rgba[1], rgba[2]};
    }
    const auto found = colours_.find(name);
    return found == colours_.end() ? std::nullopt : std::optional{found->second};
  }

  std::optional<Visual> read_visual(const XMLElement& element) {
    const XMLElement* const geometry = element.FirstChildElement("geometry");
    const XMLElement* const solid = geometry != nullptr ? geometry->FirstChildElement() : nullptr;
    if (solid == nullptr) return std::nullopt;
    Visual visual;
    const std::string_view name = solid->Name();
    if (name == "box") {
      visual.form = Form::box;
      const auto edges = numbers<3>(*solid, "size", {0, 0, 0});
      visual.size = {edges[0], edges[1], edges[2]};
    } else if (name == "cylinder" || name == "sphere") {
      const double diameter = 2 * numbers<1>(*solid, "radius", {0})[0];
      visual.form = name == "sphere" ? Form::sphere : Form::cylinder;
      visual.size = {diameter, diameter, name == "sphere" ? diameter : numbers<1>(*solid, "length", {0})[0]};
    } else {
      if (num_left_out_++ == 0) first_left_out_ = solid->GetLineNum();
      return std::nullopt;
    }
    if (!(visual.size.minCoeff() > 0)) {
      diagnostics_.error(file_, solid->GetLineNum(), fmt::format("<{}>", name), "its size is not positive");
      return std::nullopt;
    }
    if (const XMLElement* const origin = element.FirstChildElement("origin")) {
      visual.T_link_shape =
          modelgen::pose_of(numbers<3>(*origin, "xyz", {0, 0, 0}), numbers<3>(*origin, "rpy", {0, 0, 0}));
    }
    if (const XMLElement* const material = element.FirstChildElement("material")) {
      visual.colour = remember(*material).value_or(visual.colour);
    }
    return visual;
  }

  const std::string& file_;
  modelgen::Diagnostics& diagnostics_;
  std::map<std::string, Colour> colours_;
  int num_left_out_{}, first_left_out_{};  ///< meshes and unknown shapes; the line of the first
};

}  // namespace

std::vector<Visual> read_visuals(const modelgen::SourceFile& urdf, modelgen::Diagnostics& diagnostics) {
  tinyxml2::XMLDocument document;
  const XMLElement* const robot = modelgen::parse_robot(urdf, document, diagnostics);
  return robot != nullptr ? Reader{urdf.path, diagnostics}.read(*robot) : std::vector<Visual>{};
}

}  // namespace articam::picture
