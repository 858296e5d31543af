// The model compiler on a large URDF against parsing it alone.
#include <benchmark/benchmark.h>
#include <tinyxml2.h>

#include <string>
#include <utility>
#include <vector>

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

/// What FAULTS asks to be refused within 100 ms, each about as large as a file may be.
std::string repeated(const std::string& head, const std::string& part, const std::string& tail) {
  std::string text = head;
  while (text.size() + part.size() + tail.size() < modelgen::kMaxSourceBytes) text += part;
  return text + tail;
}

void hostile(benchmark::State& state, const std::string& text) {
  const modelgen::CompileJob job{{"hostile.urdf", text}, {}, "Hostile", {}};
  for (auto _ : state) {
    modelgen::Diagnostics diagnostics;
    if (modelgen::compile_model(job, diagnostics)) state.SkipWithError("was taken");
  }
}

/// Links in a chain whose joints mimic the next one, the last the first: every chain is as long as can be.
std::string mimic_cycle() {
  std::string text = "<robot name='r'><link name='l0'/>";
  for (int i = 0; i < 255; ++i) {
    const std::string n = std::to_string(i), next = std::to_string((i + 1) % 255), child = std::to_string(i + 1);
    text += "<link name='l" + child + "'/><joint name='j" + n + "' type='continuous'><parent link='l" + n +
            "'/><child link='l" + child + "'/><mimic joint='j" + next + "'/></joint>";
  }
  return text + "</robot>";
}

[[maybe_unused]] const bool kRegistered = [] {
  const std::vector<std::pair<std::string, std::string>> files{
      {"deep", repeated("<robot name='r'>", "<a>", "")},
      {"wide", repeated("<robot name='r'>", "<joint/>", "</robot>")},
      {"thorny", repeated("<robot", " a=''", "/>")},
      {"texts", repeated("<robot name='r'><link name='", "x", "'/></robot>")},
      {"comments", repeated("<robot name='r'>", "<!---->", "<link/></robot>")},
      {"instructions", repeated("<robot name='r'>", "<?a?>", "<link/></robot>")},
      {"entities", "<!DOCTYPE r [<!ENTITY a '&b;&b;'><!ENTITY b 'lol'>]><robot name='&a;'/>"},
      {"mimic_cycle", mimic_cycle()}};
  for (const auto& [name, text] : files) {
    const auto run = [text = text](benchmark::State& state) { hostile(state, text); };
    benchmark::RegisterBenchmark(("modelgen/hostile/" + name).c_str(), run)->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace articam
