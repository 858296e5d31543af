#include "host_sim/report/camera_picture.hpp"

#include <gtest/gtest.h>

#include "host_sim/scenarios/paper.hpp"
#include "tests/host_sim/report/page_words.hpp"

namespace articam::sim {
namespace {

const CameraParameters kCamera = PaperScenario::camera();
const Crop kWhole{0, 0, 640, 480};

Overlay overlay() { return {{}, scene_markers<PaperScenario::Model>(PaperScenario::at(0).q), {}, "0.00 s, tracking"}; }

TEST(CameraPicture, OfNoImageIsEmpty) {
  EXPECT_TRUE(picture_layers({}, kCamera, overlay(), kWhole).empty());
  EXPECT_TRUE(camera_picture("", kWhole).empty());
}

TEST(CameraPicture, IsCutToTheMarkersAndStaysInsideTheImage) {
  const Overlay six = overlay();
  const Crop crop = around(std::span{&six, 1}, kCamera);
  EXPECT_LT(crop.width, 640);
  EXPECT_LT(crop.height, 480);
  EXPECT_GE(crop.u, 0);
  EXPECT_GE(crop.v, 0);
  EXPECT_LE(crop.u + crop.width, 640);
  EXPECT_LE(crop.v + crop.height, 480);
  EXPECT_EQ(around({}, kCamera).width, 640);
}

TEST(CameraFilm, ShowsEveryFrameOnceATurn) {
  const std::vector<std::uint8_t> pixels(640 * 480, 100);
  const std::string shot = picture_layers({pixels.data(), 640, 480, 640}, kCamera, overlay(), kWhole);
  const std::vector<std::string> shots(5, shot);
  const std::string film = camera_film(shots, 0.2, kWhole);
  EXPECT_EQ(test::count(film, "<image "), 5u);
  EXPECT_EQ(test::count(film, "class=\"shot"), 5u);
  EXPECT_EQ(test::count(film, "class=\"shot first\""), 1u);
  EXPECT_NE(film.find("1.000s step-end infinite"), std::string::npos);  // 5 times 0.2 s
}

}  // namespace
}  // namespace articam::sim
