#include "static_models/registry.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "core/model/configuration.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/read_camera.hpp"

namespace articam::models {
namespace {

const std::string kFolder = ARTICAM_SOURCE_DIR "/static_models/";

std::string read(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Committed {
  std::string folder, type;
};

class StaticModel : public testing::TestWithParam<Committed> {};

TEST_P(StaticModel, HasTheTableThatItsSourcesGive) {
  const std::string stem = kFolder + GetParam().folder + "/" + GetParam().folder;
  modelgen::Diagnostics diagnostics;
  const auto urdf = modelgen::read_source(stem + ".urdf", diagnostics);
  const auto markers = modelgen::read_source(stem + ".markers.yaml", diagnostics);
  ASSERT_TRUE(urdf && markers) << diagnostics.text();
  const auto model = modelgen::compile_model({*urdf, markers, GetParam().type, {}}, diagnostics);
  ASSERT_TRUE(model) << diagnostics.text();
  EXPECT_EQ(diagnostics.text(), "") << "our own models give no reason for a warning";
  EXPECT_EQ(read(stem + ".hpp"), model->header)
      << "out of date; update it:  cmake --build build/host-release --target regenerate_static_models";
}

TEST_P(StaticModel, IsInTheRegistryUnderItsFolder) {
  EXPECT_TRUE(visit_model(GetParam().folder, []<class Model>() { static_assert(model::Model<Model>); }));
}

INSTANTIATE_TEST_SUITE_P(All, StaticModel,
                         testing::Values(Committed{"printer_drawer", "PrinterDrawer"}, Committed{"mire", "Mire"},
                                         Committed{"mire_distance", "MireDistance"}),
                         [](const auto& test) { return test.param.type; });

TEST(StaticModels, TellWhenANameIsNotTheirs) {
  EXPECT_FALSE(visit_model("absent", []<class Model>() {}));
}

TEST(StaticModels, StartWhereFromNumbersTakesThem) {
  for (const auto name : kStaticModelNames) {
    visit_model(name, []<class Model>() {
      static_assert(Model::kHasQ0);
      EXPECT_TRUE((model::from_numbers<Model, double>(Model::kQ0).ok())) << Model::kName;
    });
  }
}

TEST(StaticModels, ShowThePrinterInTheirReadme) {
  EXPECT_NE(read(kFolder + "README.md").find("```cpp\n" + read(kFolder + "printer_drawer/printer_drawer.hpp") + "```"),
            std::string::npos)
      << "copy static_models/printer_drawer/printer_drawer.hpp into static_models/README.md";
}

TEST(StaticModels, BringCamerasThatCanBeRead) {
  for (const char* camera : {"xtion_vga", "mire_384x288"}) {
    modelgen::Diagnostics diagnostics;
    EXPECT_TRUE(modelgen::read_camera(kFolder + "cameras/" + camera + ".yaml", diagnostics)) << diagnostics.text();
    EXPECT_EQ(diagnostics.text(), "");
  }
}

}  // namespace
}  // namespace articam::models
