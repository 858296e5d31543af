/// @file  What the front end costs, beside one vectorised pass over the frame.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/vision/detector.hpp"
#include "tests/core/vision/marker_scene.hpp"

namespace articam {
namespace {

using Pixels = std::vector<std::uint8_t>;

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

// Rings of 37 px across when untilted, in a grid of 5x4, or of 3x2 up to six.
std::vector<sim::SceneMarker> rings(int count) {
  std::mt19937 random(4);
  const int columns = count > 6 ? 5 : 3, rows = count > 6 ? 4 : 2;
  auto markers = test::grid_of_markers(model::MarkerKind::ring, columns, rows, 37, std::numbers::pi / 6, random);
  markers.resize(static_cast<std::size_t>(count));
  return markers;
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

void full(benchmark::State& state, const Pixels& pixels) {
  const auto detector = std::make_unique<vision::Detector>();
  vision::Detections found;
  for (auto _ : state) benchmark::DoNotOptimize(detector->detect(test::view_of(pixels), found));
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
  const auto detector = std::make_unique<vision::Detector>();
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
  for (const int count : {1, 6, 20}) {
    benchmark::RegisterBenchmark(("detect/tracked_window/" + std::to_string(count)).c_str(),
                                 [count](benchmark::State& state) { tracked_window(state, count); });
  }
  return true;
}();

}  // namespace
}  // namespace articam
