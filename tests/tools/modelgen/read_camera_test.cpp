#include "tools/modelgen/read_camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace articam::modelgen {
namespace {

const std::string kCamera =
    "image_width: 640\nimage_height: 480\n"
    "camera_matrix: {rows: 3, cols: 3, data: [525, 0, 319.5, 0, 524, 239.5, 0, 0, 1]}\n"
    "distortion_model: plumb_bob\n"
    "distortion_coefficients: {rows: 1, cols: 5, data: [.1, .2, .3, .4, .5]}\n";

std::string edited(std::string from, const std::string& to) {
  std::string text = kCamera;
  return text.replace(text.find(from), from.size(), to);
}

std::string messages(const std::string& yaml) {
  Diagnostics diagnostics;
  const auto camera = read_camera(SourceFile{"c.yaml", yaml}, diagnostics);
  EXPECT_EQ(camera.has_value(), !diagnostics.has_errors());
  return diagnostics.text();
}

TEST(ReadCamera, KeepsEveryNumber) {
  Diagnostics diagnostics;
  const auto camera = read_camera(SourceFile{"c.yaml", kCamera + "readout_time_s: 0.02\n"
                                                                 "T_base_cam: {position: [1, 2, 3], "
                                                                 "quaternion_wxyz: [0.8, 0, 0.6, 0]}\n"},
                                  diagnostics);
  ASSERT_TRUE(camera) << diagnostics.text();
  EXPECT_EQ(camera->width_px, 640);
  EXPECT_EQ(camera->height_px, 480);
  EXPECT_EQ((std::array{camera->fx_px, camera->fy_px, camera->cx_px, camera->cy_px}),
            (std::array{525.0, 524.0, 319.5, 239.5}));
  EXPECT_EQ(camera->distortion_model, DistortionModel::plumb_bob);
  EXPECT_EQ(camera->distortion, (std::array<double, 8>{.1, .2, .3, .4, .5}));
  EXPECT_EQ(camera->readout_time_s, 0.02);
  EXPECT_EQ(camera->t_base_cam_m, (std::array{1.0, 2.0, 3.0}));
  EXPECT_NEAR(camera->r_base_cam_wxyz[2], 0.6, 1e-15);  // divided by its norm: one rounding
}

TEST(ReadCamera, TakesTheThreeLensModelsOfRosEachWithItsCoefficients) {
  const auto with = [](const std::string& model, const std::string& numbers, int count) {
    return "image_width: 640\nimage_height: 480\n"
           "camera_matrix: {rows: 3, cols: 3, data: [525, 0, 319.5, 0, 524, 239.5, 0, 0, 1]}\n"
           "distortion_model: " +
           model + "\ndistortion_coefficients: {rows: 1, cols: " + std::to_string(count) + ", data: [" + numbers +
           "]}\n";
  };
  Diagnostics diagnostics;
  const auto rational =
      read_camera(SourceFile{"c.yaml", with("rational_polynomial", ".1, .2, .3, .4, .5, .6, .7, .8", 8)}, diagnostics);
  const auto fisheye = read_camera(SourceFile{"c.yaml", with("equidistant", ".1, .2, .3, .4", 4)}, diagnostics);
  ASSERT_TRUE(rational && fisheye) << diagnostics.text();
  EXPECT_EQ(rational->distortion_model, DistortionModel::rational_polynomial);
  EXPECT_EQ(rational->distortion, (std::array{.1, .2, .3, .4, .5, .6, .7, .8}));
  EXPECT_EQ(fisheye->distortion_model, DistortionModel::equidistant);
  EXPECT_EQ(fisheye->distortion, (std::array<double, 8>{.1, .2, .3, .4}));
  EXPECT_EQ(messages(with("equidistant", ".1, .2, .3, .4, .5", 5)),
            "c.yaml:5: distortion_coefficients cols: is not 4\n"
            "c.yaml:5: distortion_coefficients data: has 5 numbers instead of 4\n");
  EXPECT_EQ(messages(edited("plumb_bob", "magic")),
            "c.yaml:4: distortion_model: 'magic' is not known; known are plumb_bob, rational_polynomial, "
            "equidistant\n");
}

TEST(ReadCamera, TellsTheLineAndTheKeyOfWhatIsWrong) {
  const std::string of_little_use =
      "c.yaml:6: readout_time_s: warning: dates frames of V4L2 devices that stamp their end; the rows of a frame count "
      "as of one instant\n";
  EXPECT_EQ(messages(edited("525, 0", "525, 1")), "c.yaml:3: camera_matrix: is not (fx 0 cx, 0 fy cy, 0 0 1)\n");
  EXPECT_EQ(messages(edited("524", "-524")),
            "c.yaml:3: camera_matrix: has a focal length that is not between 1 and 1e5 px\n");
  EXPECT_EQ(messages(edited("525", "1e300")),
            "c.yaml:3: camera_matrix: has a focal length that is not between 1 and 1e5 px\n");
  EXPECT_EQ(messages(edited("239.5", "-4801")),
            "c.yaml:3: camera_matrix: has a principal point far outside the image\n");
  EXPECT_EQ(messages(edited(".4, .5", ".4")), "c.yaml:5: distortion_coefficients data: has 4 numbers instead of 5\n");
  EXPECT_EQ(messages(edited("rows: 1", "rows: 2")), "c.yaml:5: distortion_coefficients rows: is not 1\n");
  EXPECT_EQ(messages(edited("640", "640.5")), "c.yaml:1: image_width: 640.5 is not a whole number of pixels\n");
  EXPECT_EQ(messages(edited("640", "4000")),
            "c.yaml:1: image_width: 4000 exceeds 1280, the largest this build takes\n");
  EXPECT_EQ(messages(edited("525", ".nan")), "c.yaml:3: camera_matrix data: '.nan' is not a finite number\n");
  EXPECT_EQ(messages(kCamera + "readout_time_s: -1\n"),
            "c.yaml:6: readout_time_s: is not between 0 and 1 s\n" + of_little_use);
  EXPECT_EQ(messages(kCamera + "T_base_cam: {position: [0, 0, 0], quaternion_wxyz: [1, 1, 0, 0]}\n"),
            "c.yaml:6: T_base_cam quaternion_wxyz: has norm 1.41421, not 1\n");
  EXPECT_EQ(messages(kCamera + "readout_time_s: 0.02\n"), of_little_use);
  EXPECT_EQ(messages(kCamera + "readout_time: 1\n"), "c.yaml:6: readout_time: warning: unknown key, ignored\n");
}

TEST(ReadCamera, TellsAllErrorsInOneRun) {
  EXPECT_EQ(messages("image_width: 0\n"),
            "c.yaml:1: image_width: 0 is not a whole number of pixels\n"
            "c.yaml:1: image_height: is missing\n"
            "c.yaml:1: camera_matrix: is missing\n"
            "c.yaml:1: distortion_model: is missing\n");
}

}  // namespace
}  // namespace articam::modelgen
