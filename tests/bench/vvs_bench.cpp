/// @file  Solving for the configuration: one iteration, one solve, one step, beside a plain Eigen iteration.

#include <benchmark/benchmark.h>

#include <Eigen/Cholesky>

#include "hal/firmware.hpp"
#include "host_sim/scenarios/paper.hpp"
#include "tests/support/observe.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;

template <class S>
tracker::Matches<M, S> noisy_matches() {
  test::Random random{1};
  return test::observe<M, S>(test::nominal_printer<M, S>(), tracker::FeatureKind::imaged_circle, 0.3, &random);
}

/// 2 cm, 5 deg, 1 cm off, as the anchors' solvers were started.
template <class S>
model::Configuration<M, S> start() {
  Vec<S, 8> off;
  off << S(0.012), S(-0.01), S(0.013), S(0.05), S(-0.05), S(0.05), S(0.01), S(-0.01);
  return model::integrate<M, S>(test::nominal_printer<M, S>(), off);
}

/// One iteration as one would write it first: loops over the table, dense A, normal equations, Eigen's LDLT.
void floor_vvs_generic(benchmark::State& state) {
  const auto matches = noisy_matches<double>();
  const auto q = start<double>();
  for (auto _ : state) {
    tracker::System<M, double> system;
    const auto kinematics = model::forward_kinematics<M, double>(q.joints);
    for (std::size_t i = 0; i < matches.size(); ++i) {
      const Vec<double, 3> X = q.T_cam_obj * kinematics.markers[i].centre;
      const Vec<double, 2> s = X.head<2>() / X.z();
      const auto L = vision::interaction_matrix<double>(s, X.z());
      const auto J = model::point_jacobian<M, double>(kinematics, q.T_cam_obj, M::kMarkers[i].body);
      system.e.segment<2>(static_cast<Eigen::Index>(2 * i)) = s - matches[i].s_star;
      system.A.middleRows<2>(static_cast<Eigen::Index>(2 * i)) = -L.value() * J;
    }
    const Mat<double, 8, 8> H = system.A.transpose() * system.A;
    const Vec<double, 8> g = system.A.transpose() * system.e;
    const Vec<double, 8> step = -H.ldlt().solve(g);
    benchmark::DoNotOptimize(model::integrate<M, double>(q, step));
  }
}
BENCHMARK(floor_vvs_generic)->Name("floor/vvs_generic");

template <class S>
void vvs_iteration(benchmark::State& state) {
  const auto matches = noisy_matches<S>();
  const auto q = start<S>();
  const tracker::Prior<M, S> prior{q, Vec<S, 8>::Ones()};
  for (auto _ : state) {
    tracker::Normal<M, S> normal;
    Vec<S, 8> step = Vec<S, 8>::Zero();
    if (tracker::linearise(matches, prior, q, normal) != Status::ok) state.SkipWithError("behind the camera");
    if (tracker::damped_step<M, S>(normal, S(0), step) != Status::ok) state.SkipWithError("singular");
    benchmark::DoNotOptimize(model::integrate<M, S>(q, step));
  }
}
BENCHMARK(vvs_iteration<double>)->Name("vvs/iteration/PrinterDrawer/double");
BENCHMARK(vvs_iteration<float>)->Name("vvs/iteration/PrinterDrawer/float");
// Robust weights and prior are part of every iteration, and the centre is all that is measured: the same for now.
BENCHMARK(vvs_iteration<double>)->Name("vvs/iteration_full/PrinterDrawer/double");
BENCHMARK(vvs_iteration<float>)->Name("vvs/iteration_full/PrinterDrawer/float");

template <class S>
void vvs_solve(benchmark::State& state) {
  const auto matches = noisy_matches<S>();
  const auto q = start<S>();
  const tracker::Prior<M, S> prior{q, Vec<S, 8>::Ones()};
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
