// The model compiler on a large URDF against parsing it alone.
#include <benchmark/benchmark.h>
#include <tinyxml2.h>

#include "tools/modelgen/compile_model.hpp"

namespace articam {
namespace {

/// Depth 9, 117 links as a furnished flat has them, each with the inertia and meshes that real files carry.
std::string large_urdf() {
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"flat\">\n";
  for (int i = 0; i < 117; ++i) {
    const std::string n = std::to_string(i);
    text += "  <link name=\"link_" + n + "\">\n    <inertial>\n      <mass value=\"1\"/>\n" +
            "      <inertia ixx=\"0.01\" ixy=\"0\" ixz=\"0\" iyy=\"0.01\" iyz=\"0\" izz=\"0.01\"/>\n    </inertial>\n" +
            "    <visual>\n      <origin rpy=\"0 0 0\" xyz=\"0 0 0\"/>\n      <geometry>\n" +
            "        <mesh filename=\"package://flat/meshes/link_" + n +
            ".stl\"/>\n      </geometry>\n    </visual>\n  </link>\n";
    if (i == 0) continue;
    const std::string kind = i % 3 == 0 ? "prismatic" : (i % 8 == 0 ? "revolute" : "fixed");
    text += "  <joint name=\"joint_" + n + "\" type=\"" + kind + "\">\n    <parent link=\"link_" +
            std::to_string(i / 2) + "\"/>\n    <child link=\"link_" + n +
            "\"/>\n    <origin rpy=\"0 0 1.5707963\" xyz=\"0.125 -0.3 0.0715\"/>\n" +
            "    <axis xyz=\"0 0 1\"/>\n    <limit effort=\"300\" lower=\"0.0\" upper=\"0.48\" velocity=\"10\"/>\n  "
            "</joint>\n";
  }
  return text + "</robot>\n";
}

void floor_parse(benchmark::State& state) {
  const std::string text = large_urdf();
  for (auto _ : state) {
    tinyxml2::XMLDocument document;
    benchmark::DoNotOptimize(document.Parse(text.data(), text.size()));
  }
}
BENCHMARK(floor_parse)->Name("floor/parse_117_links")->Unit(benchmark::kMicrosecond);

void compile(benchmark::State& state) {
  const modelgen::CompileJob job{{"flat.urdf", large_urdf()}, {}, "Flat", {}};
  for (auto _ : state) {
    modelgen::Diagnostics diagnostics;
    benchmark::DoNotOptimize(modelgen::compile_model(job, diagnostics));
  }
}
BENCHMARK(compile)->Name("modelgen/117_links")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace articam
