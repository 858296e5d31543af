#include "core/vision/detector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/replay/pgm.hpp"

// Photographs of Debian's package visp-images-data.
namespace articam::vision {
namespace {

const std::filesystem::path kImages = "/usr/share/visp-images-data/ViSP-images";

struct Point {
  double u_px, v_px;
};

hal::GreyImage load(const std::filesystem::path& file) {
  hal::GreyImage image;
  std::string why;
  EXPECT_EQ(hal::read_pgm(file, image, why), Status::ok) << file << ": " << why;
  return image;
}

std::vector<std::filesystem::path> pgm_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".pgm") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::optional<Detection> nearest(const Detections& marks, Point p, double reach_px) {
  std::optional<Detection> best;
  for (const Detection& mark : marks) {
    const double radius_px = std::max(from_q16(mark.outer.m00_q16), from_q16(mark.outer.m11_q16));
    const double distance = std::hypot(from_q16(mark.outer.u_q16) - p.u_px, from_q16(mark.outer.v_q16) - p.v_px);
    if (distance >= reach_px || radius_px < 5 || radius_px > 14) continue;
    reach_px = distance;
    best = mark;
  }
  return best;
}

// An independent method: the centroid of the grey above the level half-way between the plate and the saturated dot.
Point centroid(const hal::GreyImage& image, const PixelBox& box) {
  double sum = 0, sum_u = 0, sum_v = 0;
  for (int v = box.v_min_px; v <= box.v_max_px; ++v) {
    for (int u = box.u_min_px; u <= box.u_max_px; ++u) {
      const double weight = std::max(0, image.pixels[static_cast<std::size_t>(v * image.width_px + u)] - 150);
      sum += weight;
      sum_u += weight * u;
      sum_v += weight * v;
    }
  }
  return {sum_u / sum, sum_v / sum};
}

PixelBox box_of(const Ellipse& e, int margin_px, const ImageView& image) {
  const int u = e.u_q16 >> 16, v = e.v_q16 >> 16, half_width = (e.m00_q16 >> 16) + margin_px;
  const int half_height = static_cast<int>(std::hypot(from_q16(e.m10_q16), from_q16(e.m11_q16))) + margin_px;
  return PixelBox{u - half_width, v - half_height, u + half_width, v + half_height}.clipped_to(image);
}

TEST(DetectorOnPhotographs, FindsTheFourDotsOfThePlateInEveryFrame) {
  if (!std::filesystem::is_directory(kImages / "mire-2")) GTEST_SKIP() << "visp-images-data is not installed";
  const auto detector = std::make_unique<Detector>(DetectorOptions{.rings = false, .dots_light_on_dark = true});
  std::array<Point, 4> dots{{{93, 265}, {242, 248}, {215, 166}, {85, 178}}};
  for (int i_frame = 1; i_frame <= 250; ++i_frame) {
    char name[32];
    std::snprintf(name, sizeof name, "image.%04d.pgm", i_frame);
    const hal::GreyImage image = load(kImages / "mire-2" / name);
    Detections found;
    ASSERT_EQ(detector->detect(image.view(), found), Status::ok);
    for (Point& dot : dots) {
      const auto mark = nearest(found, dot, 20);  // the plate moves by up to 15 px a frame, its dots are 60 px apart
      ASSERT_TRUE(mark.has_value()) << name << " near " << dot.u_px << ", " << dot.v_px;
      dot = {from_q16(mark->outer.u_q16), from_q16(mark->outer.v_q16)};
      const Point other = centroid(image, box_of(mark->outer, 2, image.view()));
      EXPECT_LT(std::hypot(other.u_px - dot.u_px, other.v_px - dot.v_px), 0.5) << name;
    }
  }
}

TEST(DetectorOnPhotographs, SeesNoRingWhereThereIsNone) {
  const auto detector = std::make_unique<Detector>();
  int seen = 0;
  for (const char* folder : {"mbt/cube", "cube", "line", "Klimt", "mire-2", "ellipse-1"}) {
    if (!std::filesystem::is_directory(kImages / folder)) continue;
    for (const auto& file : pgm_files(kImages / folder)) {
      Detections found;
      ASSERT_EQ(detector->detect(load(file).view(), found), Status::ok);
      EXPECT_TRUE(found.empty()) << file << " at " << from_q16(found[0].outer.u_q16) << ", "
                                 << from_q16(found[0].outer.v_q16);
      ++seen;
    }
  }
  if (seen == 0) GTEST_SKIP() << "visp-images-data is not installed";
}

}  // namespace
}  // namespace articam::vision
