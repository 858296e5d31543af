/// @file  What it costs to find the object in one frame's marks without a start.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/tracker/acquire.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/core/vision/marker_scene.hpp"
#include "tests/support/random_views.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;

/// The marks of random views, one after the other: the mean over them is what counts, `most_steps` the worst of them.
template <class Scalar>
void acquire(benchmark::State& state) {
  const vision::CameraModel<double> camera{test::kVga};
  test::Random random{3};
  std::vector<vision::Detections> views;
  for (int i = 0; i < 200; ++i) {
    views.push_back(test::detections_of<M>(test::random_view<M>(camera, {}, random), camera, 0.02, random));
  }
  const auto acquisition =
      std::make_unique<tracker::Acquisition<M, Scalar>>(vision::CameraModel<Scalar>{test::kVga}, Scalar(0.005));
  int most_steps = 0, sure = 0, frames = 0;
  for (auto _ : state) {
    acquisition->reset();
    const auto& found = acquisition->search(views[static_cast<std::size_t>(frames++) % views.size()], Scalar(25));
    most_steps = std::max(most_steps, found.work);
    sure += found.certainty == tracker::Certainty::sure ? 1 : 0;
  }
  state.counters["most_steps"] = most_steps;
  state.counters["sure"] = static_cast<double>(sure) / frames;
}

const bool kRegistered = [] {
  benchmark::RegisterBenchmark("acquire/PrinterDrawer", acquire<double>);
  benchmark::RegisterBenchmark("acquire/PrinterDrawer/float", acquire<float>);
  return true;
}();

}  // namespace
}  // namespace articam
