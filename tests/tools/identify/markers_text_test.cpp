#include "tools/identify/markers_text.hpp"

#include <gtest/gtest.h>

#include "tests/tools/identify/static_sources.hpp"
#include "tools/identify/compare_sources.hpp"

namespace articam::identify {
namespace {

using modelgen::Diagnostics, modelgen::SourceFile;

/// What is written for a model whose markers are displaced on their bodies, read back by the model compiler.
void expect_displaced(const std::string& model) {
  const SourceFile urdf = test::static_source(model, ".urdf"), markers = test::static_source(model, ".markers.yaml");
  Diagnostics diagnostics;
  const auto file = modelgen::read_markers(markers, diagnostics);
  ASSERT_TRUE(file);
  const auto axes = axes_of_frames({urdf, markers, "Tested", {}}, *file);
  std::vector<MarkerPlace> places;
  for (std::size_t m = 0; m < file->markers.size(); ++m) {
    const double i = static_cast<double>(m);
    places.push_back({file->markers[m].frame, {1e-3 * i, -2e-3, 5e-4 * i}, Mat3::Identity() * 1e-10, true, true});
  }
  const SourceFile written{"written.yaml", markers_text(*file, places, axes, file->q0)};
  const auto before = test::compile(urdf, markers).table, after = test::compile(urdf, written).table;
  ASSERT_EQ(after.markers.size(), before.markers.size());
  for (std::size_t m = 0; m < before.markers.size(); ++m) {
    const auto &a = after.markers[m], &b = before.markers[m];
    EXPECT_LT((a.t_body_m - b.t_body_m - places[m].displaced).norm(), 1e-7) << a.name;  // written to 0.1 um
    EXPECT_TRUE(a.name == b.name && a.kind == b.kind && a.body == b.body);
    EXPECT_TRUE(a.outer_diameter_m == b.outer_diameter_m && a.inner_diameter_m == b.inner_diameter_m);
  }
  EXPECT_EQ(after.q0, before.q0);
}

TEST(MarkersText, IsReadBackAsTheDisplacedMarkers) {
  for (const char* const model : {"printer_drawer", "door", "laptop", "switch_panel", "arm7"}) expect_displaced(model);
}

TEST(MarkersText, AddsToWhatAFileAlreadySaid) {
  modelgen::MarkersFile file;
  file.markers.push_back({"it's", 1, model::MarkerKind::dot_dark_on_light, 0.01, 0, {0.1, 0.2, 0.3}, "it's"});
  const std::vector<MarkerPlace> places{{"it's", {0, 0, 0.001}, Mat3::Zero(), true, false}};
  Diagnostics diagnostics;
  const auto text = markers_text(file, places, {Mat3::Identity()}, std::nullopt);
  const auto back = modelgen::read_markers({"m.yaml", text}, diagnostics);
  ASSERT_TRUE(back && !diagnostics.has_errors()) << diagnostics.text() << text;
  EXPECT_EQ(back->markers[0].frame, "it's");
  EXPECT_EQ(back->markers[0].offset_m, (std::array{0.1, 0.2, 0.301}));
  EXPECT_NE(text.find("displaced"), std::string::npos);
}

}  // namespace
}  // namespace articam::identify
