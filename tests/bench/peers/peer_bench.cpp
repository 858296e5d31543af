/// @file  What others' detectors cost on frames like those of detect/full/N; `found` counts marks within a pixel.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <opencv2/features2d.hpp>

#include "tests/bench/peers/visp_dots.hpp"
#include "tests/bench/ring_scene.hpp"

namespace articam {
namespace {

using Pixels = std::vector<std::uint8_t>;

Pixels cluttered(const std::vector<sim::SceneMarker>& markers) {
  Pixels pixels;
  sim::Renderer{test::kVga, {}}.render(markers, 0, pixels);
  return pixels;
}

class Truth {
 public:
  explicit Truth(const std::vector<sim::SceneMarker>& markers) {
    for (const sim::SceneMarker& marker : markers) places_.push_back(test::imaged(marker, marker.outer_radius_m));
  }
  const std::vector<test::TrueEllipse>& places() const { return places_; }
  void seen(double u_px, double v_px) {
    found_ += std::any_of(places_.begin(), places_.end(), [&](const test::TrueEllipse& place) {
      return std::hypot(place.u_px - u_px, place.v_px - v_px) < 1;
    });
  }
  int found() const { return found_; }

 private:
  std::vector<test::TrueEllipse> places_;
  int found_{};
};

struct Free {
  void operator()(apriltag_detector_t* detector) const { apriltag_detector_destroy(detector); }
  void operator()(apriltag_family_t* family) const { tag36h11_destroy(family); }
  void operator()(image_u8_t* image) const { image_u8_destroy(image); }
};

/// Tags where the rings are: the black border as wide as a ring, on a white margin of one cell, tilted alike, softened
/// over 2 px and with the same noise.
Pixels tags(const std::vector<sim::SceneMarker>& markers, apriltag_family_t* family) {
  Pixels pixels = cluttered({});
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 4);
  int id = 0;
  for (const sim::SceneMarker& marker : markers) {
    const std::unique_ptr<image_u8_t, Free> tag{apriltag_to_image(family, id++)};
    const Vec<double, 3> right = marker.normal_cam.unitOrthogonal(), down = right.cross(marker.normal_cam);
    const double cell_m = 2 * marker.outer_radius_m / family->width_at_border;
    const auto grey = [&](double u_px, double v_px) -> double {  // of the tag's plane there; below 0 beside the tag
      const Vec<double, 3> ray{(u_px - test::kVga.cx_px) / test::kVga.fx_px,
                               (v_px - test::kVga.cy_px) / test::kVga.fy_px, 1};
      const double depth = marker.normal_cam.dot(marker.centre_cam_m) / marker.normal_cam.dot(ray);
      const Vec<double, 3> off = depth * ray - marker.centre_cam_m;
      const int i = static_cast<int>(std::floor(off.dot(right) / cell_m + tag->width / 2.0));
      const int j = static_cast<int>(std::floor(off.dot(down) / cell_m + tag->height / 2.0));
      if (i < 0 || j < 0 || i >= tag->width || j >= tag->height) return -1;
      return tag->buf[j * tag->stride + i] > 127 ? 215 : 30;
    };
    const test::TrueEllipse place = test::imaged(marker, marker.outer_radius_m);
    const int reach = static_cast<int>(2 * bench::kDiameter_px);
    for (int v = std::max(0, static_cast<int>(place.v_px) - reach);
         v < std::min(480, static_cast<int>(place.v_px) + reach); ++v) {
      for (int u = std::max(0, static_cast<int>(place.u_px) - reach);
           u < std::min(640, static_cast<int>(place.u_px) + reach); ++u) {
        constexpr int kSide = 8;
        std::uint8_t& pixel = pixels[static_cast<std::size_t>(v * 640 + u)];
        double sum = 0;
        bool touched = false;
        for (int k = 0; k < kSide * kSide; ++k) {
          const double here =
              grey(u + 2 * ((k % kSide + 0.5) / kSide - 0.5), v + 2 * ((k / kSide + 0.5) / kSide - 0.5));
          touched |= here >= 0;
          sum += here >= 0 ? here : pixel;
        }
        if (touched) pixel = static_cast<std::uint8_t>(std::clamp(sum / (kSide * kSide) + noise(random), 0.0, 255.0));
      }
    }
  }
  return pixels;
}

void apriltag(benchmark::State& state, int count, float decimate) {
  const auto markers = bench::rings(count);
  const std::unique_ptr<apriltag_family_t, Free> family{tag36h11_create()};
  const std::unique_ptr<apriltag_detector_t, Free> detector{apriltag_detector_create()};
  apriltag_detector_add_family(detector.get(), family.get());
  detector->nthreads = 1;
  detector->quad_decimate = decimate;
  Pixels pixels = tags(markers, family.get());
  image_u8_t image{640, 480, 640, pixels.data()};
  int found = 0;
  for (auto _ : state) {
    zarray_t* detections = apriltag_detector_detect(detector.get(), &image);
    found = zarray_size(detections);
    apriltag_detections_destroy(detections);
  }
  state.counters["found"] = found;  // their codes leave no doubt which is one
}

void simple_blob(benchmark::State& state, int count) {
  const auto markers = bench::rings(count);
  const Pixels pixels = cluttered(markers);
  const cv::Mat image(480, 640, CV_8UC1, const_cast<std::uint8_t*>(pixels.data()));
  cv::SimpleBlobDetector::Params light;
  light.blobColor = 255;  // it looks at a blob's centre: of a ring it can see the hole only
  const auto detector = cv::SimpleBlobDetector::create(light);
  cv::setNumThreads(1);
  std::vector<cv::KeyPoint> blobs;
  for (auto _ : state) detector->detect(image, blobs);
  Truth truth{markers};
  for (const cv::KeyPoint& blob : blobs) truth.seen(static_cast<double>(blob.pt.x), static_cast<double>(blob.pt.y));
  state.counters["found"] = truth.found();
}

// ViSP follows discs, so that these are dark dots where the rings are.
void visp_dot2(benchmark::State& state, int count) {
  const auto markers = bench::marks(count, model::MarkerKind::dot_dark_on_light);
  Truth truth{markers};
  std::vector<bench::Place> start;
  for (const test::TrueEllipse& place : truth.places()) start.push_back({place.u_px, place.v_px});
  bench::VispDots dots{cluttered(markers), start};
  for (auto _ : state) dots.track();
  for (const auto& [u_px, v_px] : dots.centres()) truth.seen(u_px, v_px);
  state.counters["found"] = truth.found();
}

const bool kRegistered = [] {
  const auto add = [](const char* name, int count, auto run) {
    benchmark::RegisterBenchmark((name + std::to_string(count)).c_str(), run);
  };
  for (const int count : {0, 1, 6, 20}) {
    add("peer/apriltag/", count, [count](benchmark::State& state) { apriltag(state, count, 1); });
    add("peer/apriltag_decimated/", count, [count](benchmark::State& state) { apriltag(state, count, 2); });
    add("peer/simple_blob/", count, [count](benchmark::State& state) { simple_blob(state, count); });
    if (count > 0) add("peer/visp_dot2/", count, [count](benchmark::State& state) { visp_dot2(state, count); });
  }
  return true;
}();

}  // namespace
}  // namespace articam
