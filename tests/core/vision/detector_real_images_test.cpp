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

#include <opencv2/imgcodecs.hpp>

#include "hal/replay/pgm.hpp"

// Photographs of Debian's package visp-images-data.
namespace articam::vision {
namespace {

constexpr const char* kMissing = "needs the package visp-images-data";
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

bool is_picture(const std::filesystem::path& file) {
  const std::string kind = file.extension().string();
  return kind == ".pgm" || kind == ".ppm" || kind == ".png" || kind == ".jpg" || kind == ".jpeg";
}

std::optional<Detection> nearest(const Detections& marks, Point p, double reach_px, double least_radius_px) {
  std::optional<Detection> best;
  for (const Detection& mark : marks) {
    const double radius_px = std::max(from_q16(mark.outer.m00_q16), from_q16(mark.outer.m11_q16));
    const double distance = std::hypot(from_q16(mark.outer.u_q16) - p.u_px, from_q16(mark.outer.v_q16) - p.v_px);
    if (distance >= reach_px || radius_px < least_radius_px || radius_px > 14) continue;
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
  if (!std::filesystem::is_directory(kImages / "mire-2")) GTEST_SKIP() << kMissing;
  const auto detector = std::make_unique<Detector>(DetectorOptions{.rings = false, .dots_light_on_dark = true});
  std::array<Point, 4> dots{{{93, 265}, {242, 248}, {215, 166}, {85, 178}}};
  for (int i_frame = 1; i_frame <= 250; ++i_frame) {
    char name[32];
    std::snprintf(name, sizeof name, "image.%04d.pgm", i_frame);
    const hal::GreyImage image = load(kImages / "mire-2" / name);
    Detections found;
    ASSERT_EQ(detector->detect(image.view(), found), Status::ok);
    for (Point& dot : dots) {
      const auto mark = nearest(found, dot, 20, 5);  // the plate moves by up to 15 px a frame, its dots are 60 px apart
      ASSERT_TRUE(mark.has_value()) << name << " near " << dot.u_px << ", " << dot.v_px;
      dot = {from_q16(mark->outer.u_q16), from_q16(mark->outer.v_q16)};
      const Point other = centroid(image, box_of(mark->outer, 2, image.view()));
      EXPECT_LT(std::hypot(other.u_px - dot.u_px, other.v_px - dot.v_px), 0.5) << name;
    }
  }
}

// ViSP's tutorials start their blob trackers from these four centres.
TEST(DetectorOnPhotographs, FindsTheFourPublishedDotsOfTheCubeInItsFirstFrame) {
  const auto file = kImages / "cube" / "image.0000.pgm";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << kMissing;
  const auto detector = std::make_unique<Detector>(
      DetectorOptions{.rings = false, .dots_light_on_dark = true, .dots_dark_on_light = true});
  Detections found;
  ASSERT_EQ(detector->detect(load(file).view(), found), Status::ok);
  for (const Point published : {Point{192.9, 86.7}, Point{239.6, 83.4}, Point{243.5, 128.5}, Point{196.4, 131.7}}) {
    const auto mark = nearest(found, published, 3, 2.5);
    ASSERT_TRUE(mark.has_value()) << published.u_px << ", " << published.v_px;
    EXPECT_LT(std::hypot(from_q16(mark->outer.u_q16) - published.u_px, from_q16(mark->outer.v_q16) - published.v_px),
              0.3)
        << "at " << from_q16(mark->outer.u_q16) << ", " << from_q16(mark->outer.v_q16);
  }
}

/// Views of the largest size that a detector takes, which together cover the image and overlap by half.
std::vector<ImageView> parts_of(const cv::Mat& image) {
  std::vector<ImageView> parts;
  for (int v = 0; v == 0 || v + kMaxImageHeight_px / 2 < image.rows; v += kMaxImageHeight_px / 2) {
    for (int u = 0; u == 0 || u + kMaxImageWidth_px / 2 < image.cols; u += kMaxImageWidth_px / 2) {
      parts.push_back({image.ptr(v, u), std::min(image.cols - u, kMaxImageWidth_px),
                       std::min(image.rows - v, kMaxImageHeight_px), static_cast<std::ptrdiff_t>(image.step)});
    }
  }
  return parts;
}

TEST(DetectorOnPhotographs, SeesNoRingInAnyImageWithoutMarkers) {
  const auto detector = std::make_unique<Detector>();
  int images = 0;
  for (const char* folder : {"Klimt", "Solvay", "cube", "ellipse-1", "faces", "line", "mbt", "mbt-depth", "mire-2"}) {
    if (!std::filesystem::is_directory(kImages / folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kImages / folder)) {
      if (!entry.is_regular_file() || !is_picture(entry.path())) continue;
      const cv::Mat image = cv::imread(entry.path().string(), cv::IMREAD_GRAYSCALE);
      ASSERT_FALSE(image.empty()) << entry.path();
      for (const ImageView& part : parts_of(image)) {
        Detections found;
        ASSERT_EQ(detector->detect(part, found), Status::ok);
        EXPECT_TRUE(found.empty()) << entry.path() << " at " << from_q16(found[0].outer.u_q16) << ", "
                                   << from_q16(found[0].outer.v_q16);
      }
      ++images;
    }
  }
  if (images == 0) GTEST_SKIP() << kMissing;
  RecordProperty("images", images);
}

}  // namespace
}  // namespace articam::vision
