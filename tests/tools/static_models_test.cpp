#include "static_models/registry.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "core/model/configuration.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/emit_camera.hpp"
#include "tools/modelgen/read_camera.hpp"
#include "tools/picture/scene.hpp"

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

/// The list of static_models/CMakeLists.txt, `Type:folder` by `Type:folder`.
std::vector<Committed> committed() {
  std::vector<Committed> models;
  std::istringstream list(ARTICAM_STATIC_MODELS);
  for (std::string word; list >> word;) {
    models.push_back({word.substr(word.find(':') + 1), word.substr(0, word.find(':'))});
  }
  return models;
}

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

TEST_P(StaticModel, HidesNoneOfItsMarkersFromTheCameraAtTheStart) {
  const std::string stem = kFolder + GetParam().folder + "/" + GetParam().folder;
  modelgen::Diagnostics diagnostics;
  const auto urdf = modelgen::read_source(stem + ".urdf", diagnostics);
  const auto markers = modelgen::read_source(stem + ".markers.yaml", diagnostics);
  ASSERT_TRUE(urdf && markers) << diagnostics.text();
  const auto scene = picture::scene_of(*urdf, *markers, diagnostics);
  ASSERT_TRUE(scene) << diagnostics.text();
  EXPECT_EQ(picture::hidden_markers(*scene), std::vector<std::string>{});
}

TEST_P(StaticModel, IsInTheRegistryUnderItsFolder) {
  EXPECT_TRUE(visit_model(GetParam().folder, []<class Model>() { static_assert(model::Model<Model>); }));
}

INSTANTIATE_TEST_SUITE_P(All, StaticModel, testing::ValuesIn(committed()),
                         [](const auto& test) { return test.param.type; });

TEST(StaticModels, AreTheSameListForCMakeAndForTheCompiler) { EXPECT_EQ(committed().size(), kStaticModelNames.size()); }

TEST(StaticCameras, AreWhatTheirSourcesGive) {
  for (const auto& [stem, type] : {std::pair{"xtion_vga", "XtionVga"}, std::pair{"mire_384x288", "Mire384x288"}}) {
    const std::string path = kFolder + "cameras/" + stem;
    modelgen::Diagnostics diagnostics;
    const auto source = modelgen::read_source(path + ".yaml", diagnostics);
    ASSERT_TRUE(source) << diagnostics.text();
    const auto camera = modelgen::read_camera(*source, diagnostics);
    ASSERT_TRUE(camera) << diagnostics.text();
    EXPECT_EQ(read(path + ".hpp"), modelgen::emit_camera(*camera, *source, type))
        << "out of date; update it:  cmake --build build/host-release --target regenerate_static_models";
  }
}

/// Every number differs from every other and from its default: none can be left out or take another's place.
constexpr const char* kCamera = R"(image_width: 641
image_height: 479
camera_matrix: {rows: 3, cols: 3, data: [525.25, 0, 319.5, 0, 524.1, 239.25, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0.1, -0.2, 0.003, 0.0004, 1e-5]}
readout_time_s: 0.02
T_base_cam: {position: [1.5, -2.5, 0.1], quaternion_wxyz: [0.8, 0, 0.6, 0]}
)";

TEST(EmittedCamera, SaysEveryNumberOfItsFile) {
  modelgen::Diagnostics diagnostics;
  const modelgen::SourceFile source{"folder/front.yaml", kCamera};
  const auto camera = modelgen::read_camera(source, diagnostics);
  ASSERT_TRUE(camera) << diagnostics.text();
  const std::string header = modelgen::emit_camera(*camera, source, "Front");
  for (const char* const text :
       {"constexpr CameraParameters kFront{", ".width_px = 641,", ".height_px = 479,", ".fx_px = 525.25,",
        ".fy_px = 524.1,", ".cx_px = 319.5,", ".cy_px = 239.25,", ".distortion = {0.1, -0.2, 0.003, 4e-04, 1e-05},",
        ".readout_time_s = 0.02,", ".has_t_base_cam = true,", ".t_base_cam_m = {1.5, -2.5, 0.1},",
        ".r_base_cam_wxyz = {0.8, 0, 0.6, 0},", "//   camera  front.yaml  sha256 "}) {
    EXPECT_NE(header.find(text), std::string::npos) << text << "\nis not in\n" << header;
  }
}

TEST(EmittedCamera, NamesItsLensAndGivesAsManyCoefficientsAsThatHas) {
  CameraParameters camera;
  camera.distortion_model = DistortionModel::equidistant;
  camera.distortion = {-0.02, 0.01, -0.003, 0.001};
  const std::string header = modelgen::emit_camera(camera, {"fisheye.yaml", ""}, "Fisheye");
  EXPECT_NE(header.find(".distortion_model = DistortionModel::equidistant,"), std::string::npos) << header;
  EXPECT_NE(header.find(".distortion = {-0.02, 0.01, -0.003, 0.001},"), std::string::npos) << header;
}

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
