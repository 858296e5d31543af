#include "tools/modelgen/read_markers.hpp"

#include <gtest/gtest.h>

namespace articam::modelgen {
namespace {

std::string messages(const std::string& yaml) {
  Diagnostics diagnostics;
  (void)read_markers({"m.yaml", yaml}, diagnostics);
  return diagnostics.text();
}

std::string marker(const std::string& rest) { return "markers:\n  - {frame: a, " + rest + "}\n"; }

TEST(ReadMarkers, KeepsKindSizeOrderAndStart) {
  Diagnostics diagnostics;
  const auto file = read_markers({"m.yaml",
                                  "markers:\n"
                                  "  - {frame: b, type: ring, outer_diameter_m: 0.05, inner_diameter_m: 0.02}\n"
                                  "  - {frame: a, type: dot, diameter_m: 0.01, polarity: dark_on_light}\n"
                                  "q0: [0, 0, .5, 1, 0, 0, 0]\n"},
                                 diagnostics);
  ASSERT_TRUE(file);
  EXPECT_EQ(diagnostics.text(), "");
  ASSERT_EQ(file->markers.size(), 2u);
  EXPECT_EQ(file->markers[0].frame, "b");
  EXPECT_EQ(file->markers[0].kind, model::MarkerKind::ring);
  EXPECT_EQ(file->markers[0].inner_diameter_m, 0.02);
  EXPECT_EQ(file->markers[1].kind, model::MarkerKind::dot_dark_on_light);
  EXPECT_EQ(file->markers[1].outer_diameter_m, 0.01);
  EXPECT_EQ(file->q0, (std::vector<double>{0, 0, .5, 1, 0, 0, 0}));
}

TEST(ReadMarkers, TellsTheLineAndTheKeyOfWhatIsWrong) {
  EXPECT_EQ(messages(marker("type: cross")), "m.yaml:2: marker 1 type: 'cross' is neither ring nor dot\n");
  EXPECT_EQ(messages(marker("type: dot, diameter_m: 0.01")), "m.yaml:2: marker 1 polarity: is missing\n");
  EXPECT_EQ(messages(marker("type: dot, diameter_m: 0.01, polarity: grey")),
            "m.yaml:2: marker 1 polarity: is neither light_on_dark nor dark_on_light\n");
  EXPECT_EQ(messages(marker("type: dot, diameter_m: -1, polarity: light_on_dark")),
            "m.yaml:2: marker 1 diameter_m: -1 is not between 0 and 10 m\n");
  EXPECT_EQ(messages(marker("type: ring, outer_diameter_m: 0.02, inner_diameter_m: 0.05")),
            "m.yaml:2: marker 1 inner_diameter_m: is not smaller than outer_diameter_m\n");
  EXPECT_EQ(messages(marker("type: ring, outer_diameter_m: '0,05', inner_diameter_m: 0.01")),
            "m.yaml:2: marker 1 outer_diameter_m: '0,05' is not a finite number\n");
  EXPECT_EQ(messages(marker("type: dot, diameter_m: 0.01, polarity: light_on_dark, colour: red")),
            "m.yaml:2: marker 1 colour: unknown key; known are frame, type, diameter_m, polarity, offset_m\n");
  EXPECT_EQ(messages("markers:\n  - {type: dot, diameter_m: 0.01, polarity: light_on_dark}\n"),
            "m.yaml:2: marker 1 frame: is missing\n");
  EXPECT_EQ(messages("markers: []\nq0: [1, x]\n"), "m.yaml:2: q0: 'x' is not a finite number\n");
  EXPECT_EQ(messages("q0: [1]\n"), "m.yaml:1: markers: is not a list of markers\n");
  EXPECT_EQ(messages("markers: [1]\n"), "m.yaml:1: marker 1: is not a mapping of keys to values\n");
  EXPECT_EQ(messages("markers: []\nmarkers: []\n"), "m.yaml:2: markers: is given twice; keep one\n");
}

TEST(ReadMarkers, TakesAPlaceBesideTheOriginOfTheFrame) {
  const std::string dot = "type: dot, diameter_m: 0.01, polarity: light_on_dark, offset_m: ";
  Diagnostics diagnostics;
  const auto file = read_markers({"m.yaml", marker(dot + "[0.1, -0.2, 3e-3]")}, diagnostics);
  ASSERT_TRUE(file);
  EXPECT_EQ(diagnostics.text(), "");
  EXPECT_EQ(file->markers[0].offset_m, (std::array{0.1, -0.2, 3e-3}));
  EXPECT_EQ(messages(marker(dot + "[0, 0, 12]")), "m.yaml:2: marker 1 offset_m: 12 is not within 10 m\n");
  EXPECT_NE(messages(marker(dot + "[0, 0]")), "");
}

TEST(ReadMarkers, RefusesRingsThatTheDetectorCannotFind) {
  const auto ring = [](const std::string& frame, const std::string& inner) {
    return "  - {frame: " + frame + ", type: ring, outer_diameter_m: 0.05, inner_diameter_m: " + inner + "}\n";
  };
  EXPECT_EQ(messages("markers:\n" + ring("a", "0.009")),
            "m.yaml:2: marker 1 inner_diameter_m: is 0.18 of outer_diameter_m; the detector finds rings of 0.1875 to "
            "0.75\n");
  EXPECT_NE(messages("markers:\n" + ring("a", "0.04")), "");
  EXPECT_EQ(messages("markers:\n" + ring("a", "0.0205") + ring("b", "0.02049")), "") << "rounded by hand";
  EXPECT_EQ(
      messages("markers:\n" + ring("a", "0.02") + ring("b", "0.025")),
      "m.yaml:3: marker 'b': its ratio of inner to outer diameter is 0.5, but 0.4 in line 2; all rings of a model "
      "need the same\n");
}

TEST(ReadMarkers, RefusesWhatIsNotYaml) {
  EXPECT_EQ(messages("- 1\n"), "m.yaml:1: document: is not a mapping of keys to values\n");
  EXPECT_EQ(messages("markers: [\n").substr(0, 45), "m.yaml:2: document: not well-formed YAML: end");
}

}  // namespace
}  // namespace articam::modelgen
