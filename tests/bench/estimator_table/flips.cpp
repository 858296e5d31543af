/// @file  A flat object seen nearly from its front and its mirror image differ by little: does the output jump?

#include <memory>
#include <numbers>

#include "tests/bench/estimator_table/printer_tracker.hpp"
#include "tests/bench/estimator_table/table.hpp"

namespace articam::estimator_table {
namespace {

struct View {
  double z_m, noise_px, open_m;
  bool shapes;
};

/// Nodding by up to 6 degrees about both axes, now this side, now that.
PrinterConfiguration nodding(const View& view, double t_s, double phase) {
  constexpr double kMost_rad = 6 * kDegree, kTurn = 2 * std::numbers::pi;
  const double pitch = kMost_rad * std::sin(kTurn * 0.11 * t_s + phase),
               roll = kMost_rad * std::sin(kTurn * 0.07 * t_s + 2 * phase);
  auto q = configuration<Printer>(view.z_m, {0, 0, 0}, view.open_m, 0.12);
  q.T_cam_obj.R = math::exp_so3<double>({roll, pitch, 0});
  return q;
}

struct Flips {
  int flips{}, flipped{}, missing{}, frames{};
};

/// Flipped is an estimate whose plane is nearer to the mirror image's than to the true one, where the two are apart by
/// 3 degrees and by five deviations of that tilt, as the bound has it.
bool is_flipped(const PrinterConfiguration& truth, const PrinterConfiguration& q, const Noise& noise) {
  const Vec<double, 3> middle = truth.T_cam_obj * Vec<double, 3>{0, -0.04, 0}, u = middle.normalized();
  const Vec<double, 3> n = truth.T_cam_obj.R * Vec<double, 3>::UnitZ(), mirrored = 2 * u.dot(n) * u - n;
  const Vec<double, 3> given = q.T_cam_obj.R * Vec<double, 3>::UnitZ();
  const double apart = (mirrored - n).norm();
  if (apart < 3 * kDegree || (given - mirrored).norm() > (given - n).norm()) return false;
  const Mat8 covariance = information<Printer>(truth, variances_of(noise), 1, 0.005).inverse();
  const Vec<double, 3> axis = n.cross(mirrored).normalized();
  return apart > 5 * std::sqrt(axis.dot(covariance.block<3, 3>(3, 3) * axis));
}

void follow(const View& view, std::uint64_t seed, Flips& count) {
  const Noise noise{view.noise_px, view.shapes ? view.noise_px : 0};
  test::Random random{seed};
  const double phase = random.uniform(-std::numbers::pi, std::numbers::pi);
  const auto tracker = std::make_unique<PrinterTracker>(sim::PaperScenario::camera(), without_floor());
  Vec8 off = random.vector<double, kDof>(-0.02, 0.02);  // 2 cm, 1 degree
  off.tail<2>().setZero();
  tracker->set_start(model::integrate<Printer, double>(nodding(view, 0, phase), off));
  bool was = false;
  for (int frame = 0; frame < 1800; ++frame) {
    const auto truth = nodding(view, frame * kFrame_s, phase);
    const auto estimate =
        tracker->step(detections_of(observe(images_of<Printer>(truth), noise, random), noise), {}, time_of(frame));
    ++count.frames;
    if (!has_estimate(estimate)) {
      ++count.missing;
      continue;
    }
    const bool is = is_flipped(truth, estimate.q, noise);
    count.flips += is && !was ? 1 : 0, count.flipped += is ? 1 : 0;
    was = is;
  }
}

}  // namespace

void flips(const Run& run, Table& table) {
  for (const View& view : {View{0.7, 0.1, 0, false},
                           {0.7, 0.3, 0, false},
                           {1.2, 0.3, 0, false},
                           {2, 0.1, 0, false},
                           {2, 0.1, 0, true},
                           {2, 0.1, 0.08, false}}) {
    const auto what = fmt::format("{} m, {} px, {}, drawer {}", view.z_m, view.noise_px,
                                  view.shapes ? "centres and shapes" : "centres", view.open_m > 0 ? "open" : "closed");
    run.progress(what);
    Flips count;
    const int seeds = run.part(20);
    for (int seed = 0; seed < seeds; ++seed) follow(view, run.seed + static_cast<std::uint64_t>(seed), count);
    table.row(fmt::format("{}, {} seeds: flips", what, seeds), "0", std::to_string(count.flips), count.flips == 0);
    table.tell("its frames flipped, without an estimate",
               fmt::format("{}, {} of {}", count.flipped, count.missing, count.frames));
  }
}

}  // namespace articam::estimator_table
