#include "host_sim/report/report_html.hpp"

#include <gtest/gtest.h>

#include "host_sim/report/camera_picture.hpp"
#include "host_sim/scenarios/paper.hpp"
#include "tests/host_sim/report/synthetic_run.hpp"

namespace articam::sim {
namespace {

std::size_t count(const std::string& page, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = page.find(word); at != std::string::npos; at = page.find(word, at + 1)) ++n;
  return n;
}

std::string page() {
  const CameraParameters camera = PaperScenario::camera();
  const std::vector<std::uint8_t> pixels(640 * 480, 100);
  const auto markers = scene_markers<PaperScenario::Model>(PaperScenario::at(0).q);
  const std::string picture = camera_picture({pixels.data(), 640, 480, 640}, camera, markers);
  const std::vector<Figure> figures(5, Figure{"caption", "<svg></svg>"});
  const RunRecord run = test::late_run();
  return report_html(run, evaluate(run), picture, 3.0, figures);
}

TEST(ReportHtml, NeedsNothingFromOutside) {
  const std::string html = page();
  EXPECT_EQ(count(html, "http:"), 0u);
  EXPECT_EQ(count(html, "https:"), 0u);
  EXPECT_EQ(count(html, "src="), 0u);
  EXPECT_EQ(count(html, "<link"), 0u);
  EXPECT_EQ(count(html, "href=\"data:image/png;base64,"), 1u);
  EXPECT_EQ(count(html, "href="), 1u);
}

TEST(ReportHtml, ShowsTheCameraFrameAndFiveFigures) {
  const std::string html = page();
  EXPECT_EQ(count(html, "<figure>"), 6u);
  EXPECT_EQ(count(html, "</figure>"), 6u);
  EXPECT_NE(html.find("slide, lag"), std::string::npos);
  EXPECT_EQ(html.find("distance, lag"), std::string::npos);
}

TEST(CameraPicture, OfNoImageIsEmpty) { EXPECT_TRUE(camera_picture({}, PaperScenario::camera(), {}).empty()); }

}  // namespace
}  // namespace articam::sim
