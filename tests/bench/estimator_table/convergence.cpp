/// @file  How far off a start may be.

#include <memory>

#include "tests/bench/estimator_table/printer_tracker.hpp"
#include "tests/bench/estimator_table/table.hpp"

namespace articam::estimator_table {
namespace {

/// Turned by that angle about any axis, moved by that length in any direction; joints as the model's file has them.
template <class M>
model::Configuration<M, double> displaced(const model::Configuration<M, double>& q, double turn_rad, double way_m,
                                          test::Random& random) {
  const auto direction = [&random] {
    for (;;) {
      const Vec<double, 3> v = random.vector<double, 3>(-1, 1);
      if (v.squaredNorm() < 1 && v.squaredNorm() > 1e-3) return Vec<double, 3>(v.normalized());
    }
  };
  Vec8 step = Vec8::Zero();
  step.head<3>() = way_m * direction(), step.segment<3>(3) = turn_rad * direction();
  auto start = model::integrate<M, double>(q, step);
  start.joints = {Printer::kQ0[7], Printer::kQ0[8]};
  return start;
}

/// In deviations of what a frame can tell.
template <class M>
double farthest(const model::Configuration<M, double>& from, const model::Configuration<M, double>& to,
                const Vec8& bound) {
  return model::difference<M, double>(from, to).cwiseAbs().cwiseQuotient(bound).maxCoeff();
}

struct Start {
  double turn_deg, way_m, asked_percent;  ///< 0: not asked
};

std::string name(const Start& start) { return fmt::format("{} deg, {} cm", start.turn_deg, 100 * start.way_m); }

/// The solver alone, the marks' names given: the optimum is where it arrives from the truth.
void solved(const Run& run, Table& table, const Start& far, bool open, const Noise& noise) {
  constexpr int kIterations = 48;  // what the tracker spends on a start
  using M = Printer;
  const auto truth = nominal<M>();
  const Images images = images_of<M>(truth);
  const Vec8 bound = deviations(information<M>(truth, variances_of(noise)));
  test::Random random{run.seed};
  int arrived = 0;
  const int trials = run.part(2000);
  for (int trial = 0; trial < trials; ++trial) {
    const auto matches = matches_of<M, double>(observe(images, noise, random), noise);
    const auto start = displaced<M>(truth, far.turn_deg * kDegree, far.way_m, random);
    tracker::Prior<M, double> prior{.mean = start};
    if (open) prior = tracker::open_prior<M, double>(start);
    const auto optimum = tracker::solve<M, double>(matches, prior, truth, kIterations).q;
    const auto found = tracker::solve<M, double>(matches, prior, start, kIterations);
    arrived += found.status == Status::ok && farthest<M>(optimum, found.q, bound) < 0.1 ? 1 : 0;
  }
  const double percent = 100.0 * arrived / trials;
  const auto what = fmt::format("one solve, {}, {}, {}", name(far), open ? "open prior" : "no prior",
                                noise.shape_px > 0 ? "centres and shapes" : "centres");
  const auto got = fmt::format("{:.2f} %", percent);
  if (far.asked_percent > 0) {
    table.row(what, fmt::format("{} %", far.asked_percent), got, percent >= far.asked_percent);
  } else {
    table.tell(what, got);
  }
}

/// The tracker, which begins anew from the frame's own marks where a start leads nowhere.
void restarted(const Run& run, Table& table, const Start& far) {
  constexpr Noise kNoise{0.1, 0.1};
  constexpr int kMostFrames = 10;
  constexpr double kPrintScale = 0.005;  // as the tracker takes it
  const auto truth = nominal<Printer>();
  const Images images = images_of<Printer>(truth);
  const Vec8 bound = deviations(information<Printer>(truth, variances_of(kNoise), 1, kPrintScale));
  const auto tracker = std::make_unique<PrinterTracker>(sim::PaperScenario::camera(), without_floor());
  test::Random random{run.seed};
  int at_once = 0, arrived = 0, wrong = 0;
  const int trials = run.part(2000);
  for (int trial = 0; trial < trials; ++trial) {
    tracker->set_start(displaced<Printer>(truth, far.turn_deg * kDegree, far.way_m, random));
    for (int frame = 0; frame < kMostFrames; ++frame) {
      const auto estimate = tracker->step(detections_of(observe(images, kNoise, random), kNoise), {},
                                          time_of(trial * 2 * kMostFrames + frame));
      if (!has_estimate(estimate)) continue;
      const bool there = farthest<Printer>(truth, estimate.q, bound) < 6;
      wrong += there ? 0 : 1;
      if (!there) continue;
      ++arrived, at_once += frame == 0 ? 1 : 0;
      break;
    }
  }
  const double percent = 100.0 * arrived / trials;
  const auto what = fmt::format("tracker with restart, {}: within {} frames (in the first)", name(far), kMostFrames);
  const auto got = fmt::format("{:.2f} % ({:.2f} %)", percent, 100.0 * at_once / trials);
  if (far.asked_percent > 0) {
    table.row(what, fmt::format("{} %", far.asked_percent), got, percent >= far.asked_percent);
  } else {
    table.tell(what, got);
  }
  table.tell("its wrong estimates", fmt::format("{} of {} starts", wrong, trials));
}

}  // namespace

void convergence(const Run& run, Table& table) {
  for (const Start& far : {Start{20, 0.20, 100}, {30, 0.25, 99.9}, {50, 0.42, 0}, {60, 0.50, 0}}) {
    run.progress(name(far));
    solved(run, table, far, false, {0.3, 0});
    solved(run, table, {far.turn_deg, far.way_m, 0}, true, {0.3, 0});
    solved(run, table, {far.turn_deg, far.way_m, 0}, false, {0.3, 0.3});
  }
  run.progress("with restart");
  restarted(run, table, {30, 0.25, 0});
  restarted(run, table, {60, 0.50, 99.5});
}

}  // namespace articam::estimator_table
