/// @file  Solving for the configuration: one iteration, one solve, one step, beside a plain Eigen iteration.

#include <benchmark/benchmark.h>

#include "hal/firmware.hpp"
#include "host_sim/scenarios/paper.hpp"
#include "tests/bench/iterations.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;

template <class Model, class S>
const bench::Frame<Model, S>& frame() {
  static const bench::Frame<Model, S> frame{model::from_numbers<Model, S>(Model::kQ0).value()};
  return frame;
}
/// The anchors' scene.
template <class S>
const bench::Frame<M, S>& nominal() {
  static const bench::Frame<M, S> frame{test::nominal_printer<M, S>()};
  return frame;
}

void floor_vvs_generic(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(bench::generic_iteration(nominal<double>()));
}
BENCHMARK(floor_vvs_generic)->Name("floor/vvs_generic");

template <class S>
void vvs_iteration(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(bench::iteration(nominal<S>()));
}
BENCHMARK(vvs_iteration<double>)->Name("vvs/iteration/PrinterDrawer/double");
BENCHMARK(vvs_iteration<float>)->Name("vvs/iteration/PrinterDrawer/float");

template <class S>
void vvs_iteration_full(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(bench::iteration_full(nominal<S>()));
}
BENCHMARK(vvs_iteration_full<double>)->Name("vvs/iteration_full/PrinterDrawer/double");
BENCHMARK(vvs_iteration_full<float>)->Name("vvs/iteration_full/PrinterDrawer/float");

template <class Model>
void vvs_growth(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(bench::iteration(frame<Model, double>()));
}
BENCHMARK(vvs_growth<M>)->Name("vvs/growth/6");
BENCHMARK(vvs_growth<bench::Printer48>)->Name("vvs/growth/48");
BENCHMARK(vvs_growth<bench::Chains24x48>)->Name("vvs/growth/24x48");

void floor_growth(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(bench::generic_iteration(frame<bench::Chains24x48, double>()));
}
BENCHMARK(floor_growth)->Name("floor/vvs_generic/24x48");

template <class S>
void vvs_solve(benchmark::State& state) {
  const auto& [matches, whole, q, prior] = nominal<S>();
  for (auto _ : state) benchmark::DoNotOptimize(tracker::solve(matches, prior, q, 20));
}
BENCHMARK(vvs_solve<double>)->Name("vvs/solve/PrinterDrawer/double");
BENCHMARK(vvs_solve<float>)->Name("vvs/solve/PrinterDrawer/float");

/// Image to estimate while tracking six rings; two frames alternate, so that nothing is remembered.
void step(benchmark::State& state) {
  using Scenario = sim::PaperScenario;
  sim::Renderer renderer{Scenario::camera(), {}};
  std::vector<std::uint8_t> images[2];
  for (std::size_t i = 0; i < 2; ++i) {
    renderer.render(sim::scene_markers<M>(Scenario::at(6.0 + static_cast<double>(i) / 30).q), i, images[i]);
  }
  tracker::Tracker<M, DefaultScalar> tracker{Scenario::camera()};
  std::int64_t k = 0;
  for (auto _ : state) {
    const ImageView image{images[k % 2].data(), 640, 480, 640};
    benchmark::DoNotOptimize(tracker.step(image, from_seconds(static_cast<double>(++k) / 30)));
  }
}
BENCHMARK(step)->Name("step/PrinterDrawer");

}  // namespace
}  // namespace articam
