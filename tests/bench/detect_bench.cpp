/// @file  What the front end costs, beside one vectorised pass over the frame.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/vision/camera_model.hpp"
#include "core/vision/detector.hpp"
#include "core/vision/imaged_ellipse.hpp"
#include "core/vision/lens_ellipse.hpp"
#include "tests/bench/ring_scene.hpp"
#include "tests/core/vision/marker_scene.hpp"

namespace articam {
namespace {

using Pixels = std::vector<std::uint8_t>;
using bench::rings;

void frame_pass(benchmark::State& state) {
  Pixels in(640 * 480), out(640 * 480);
  std::mt19937 random(1);
  for (auto& pixel : in) pixel = static_cast<std::uint8_t>(random());
  std::uint8_t threshold = 128;
  benchmark::DoNotOptimize(threshold);
  for (auto _ : state) {
    const std::uint8_t* s = in.data();
    std::uint8_t* d = out.data();
    for (std::size_t i = 0; i < 640 * 480; ++i) d[i] = s[i] > threshold ? 255 : 0;
    benchmark::ClobberMemory();
  }
}

Pixels cluttered(int count) {
  sim::Renderer renderer(test::kVga, {});
  Pixels pixels;
  renderer.render(rings(count), 0, pixels);
  return pixels;
}

Pixels checker(int size_px) {
  Pixels pixels(640 * 480);
  for (int i = 0; i < 640 * 480; ++i) {
    pixels[static_cast<std::size_t>(i)] = ((i % 640 / size_px + i / 640 / size_px) & 1) != 0 ? 230 : 20;
  }
  return pixels;
}

Pixels random_blocks(unsigned size_px) {
  Pixels pixels(640 * 480);
  for (unsigned i = 0; i < 640 * 480; ++i) {
    std::minstd_rand block(1 + i % 640 / size_px + 640 * (i / 640 / size_px));
    block.discard(2);
    pixels[i] = static_cast<std::uint8_t>(block() >> 8);
  }
  return pixels;
}

// Each just too small a hole, so that it costs both fits and fills no list.
Pixels dense_rings(double diameter_px) {
  std::mt19937 random(6);
  sim::Renderer renderer(test::kVga, {.clutter = false});
  const int columns = static_cast<int>(640 / (1.5 * diameter_px)), rows = static_cast<int>(480 / (1.5 * diameter_px));
  auto markers = test::grid_of_markers(model::MarkerKind::ring, columns, rows, diameter_px, 0, random);
  for (sim::SceneMarker& marker : markers) marker.inner_radius_m *= 0.8;
  Pixels pixels;
  renderer.render(markers, 0, pixels);
  return pixels;
}

std::unique_ptr<vision::Detector> calibrated_detector() {
  return std::make_unique<vision::Detector>(vision::DetectorOptions{.camera = vision::pinhole_of(test::kVga)});
}

// The slowest of what a scene without marks, or a hostile one, may hold.
Pixels worst() {
  std::vector<Pixels> frames;
  for (const int size_px : {1, 2, 3, 4}) frames.push_back(checker(size_px));
  for (const unsigned size_px : {1u, 2u, 3u}) frames.push_back(random_blocks(size_px));
  for (const double diameter_px : {10.0, 12.0, 16.0}) frames.push_back(dense_rings(diameter_px));
  const auto detector = calibrated_detector();
  const auto cost = [&detector](const Pixels& pixels) {
    vision::Detections found;
    auto least = std::chrono::nanoseconds::max();
    for (int run = 0; run < 5; ++run) {
      const auto start = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(detector->detect(test::view_of(pixels), found));
      least = std::min<std::chrono::nanoseconds>(least, std::chrono::steady_clock::now() - start);
    }
    return least;
  };
  return *std::max_element(frames.begin(), frames.end(),
                           [&cost](const Pixels& a, const Pixels& b) { return cost(a) < cost(b); });
}

void full(benchmark::State& state, const Pixels& pixels) {
  const auto detector = calibrated_detector();
  vision::Detections found;
  for (auto _ : state) benchmark::DoNotOptimize(detector->detect(test::view_of(pixels), found));
  state.counters["marks"] = static_cast<double>(found.size());
}

// The ellipse that the marker's edge shows.
vision::Ellipse ellipse_of(const sim::SceneMarker& marker) {
  const vision::CameraModel<double> camera(test::kVga);
  const auto on_plane = vision::imaged_ellipse<double>({marker.centre_cam_m, marker.normal_cam, marker.outer_radius_m});
  return vision::to_q16(vision::distorted_ellipse(on_plane.value(), camera).value());
}

void tracked(benchmark::State& state, int count) {
  const Pixels pixels = cluttered(count);
  std::vector<vision::Expected> expected;
  for (const sim::SceneMarker& marker : rings(count)) {
    expected.push_back({vision::MarkKind::ring, ellipse_of(marker)});
    expected.back().outer.u_q16 += 65536;
  }
  const auto detector = calibrated_detector();
  vision::Detections found;
  for (auto _ : state) benchmark::DoNotOptimize(detector->measure(test::view_of(pixels), expected, found));
  state.counters["marks"] = static_cast<double>(found.size());
}

void tracked_window(benchmark::State& state, int count) {
  const Pixels pixels = cluttered(count);
  std::vector<PixelBox> windows;
  for (const sim::SceneMarker& marker : rings(count)) {
    const test::TrueEllipse e = test::imaged(marker, test::kRadius_m);
    const int u = static_cast<int>(e.u_px), v = static_cast<int>(e.v_px), reach = static_cast<int>(e.major_px) + 10;
    windows.push_back({u - reach, v - reach, u + reach, v + reach});
  }
  const auto detector = calibrated_detector();
  vision::Detections found;
  for (auto _ : state) benchmark::DoNotOptimize(detector->detect(test::view_of(pixels), windows, found));
  state.counters["marks"] = static_cast<double>(found.size());
}

const bool kRegistered = [] {
  benchmark::RegisterBenchmark("floor/frame_pass", frame_pass);
  for (const int count : {0, 1, 6, 20}) {
    benchmark::RegisterBenchmark(("detect/full/" + std::to_string(count)).c_str(),
                                 [pixels = cluttered(count)](benchmark::State& state) { full(state, pixels); });
  }
  benchmark::RegisterBenchmark("detect/full/checker",
                               [pixels = checker(2)](benchmark::State& state) { full(state, pixels); });
  benchmark::RegisterBenchmark("detect/full/worst", [](benchmark::State& state) {
    static const Pixels pixels = worst();  // sought when it is first run, not at every start of the program
    full(state, pixels);
  });
  for (const int count : {1, 6, 20}) {
    benchmark::RegisterBenchmark(("detect/tracked/" + std::to_string(count)).c_str(),
                                 [count](benchmark::State& state) { tracked(state, count); });
    benchmark::RegisterBenchmark(("detect/tracked_window/" + std::to_string(count)).c_str(),
                                 [count](benchmark::State& state) { tracked_window(state, count); });
  }
  return true;
}();

}  // namespace
}  // namespace articam
