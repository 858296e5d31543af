/// @file  What the marks' size and shape add for a drawer that is seen along its axis, in rendered frames.

#include <memory>
#include <vector>

#include "host_sim/world/renderer.hpp"
#include "tests/bench/estimator_table/printer_tracker.hpp"
#include "tests/bench/estimator_table/table.hpp"

namespace articam::estimator_table {
namespace {

/// Mean and root mean square of the drawer's error, in m.
class DrawerError {
 public:
  void add(const PrinterConfiguration& truth, const PrinterConfiguration& q) {
    const double error = q.joints[0] - truth.joints[0];
    sum_ += error, sum2_ += error * error, ++n_;
  }
  double rms_mm() const { return 1e3 * std::sqrt(sum2_ / n_); }
  double mean_mm() const { return 1e3 * sum_ / n_; }

 private:
  double sum_{}, sum2_{};
  int n_{};
};

/// The frame's matches as the detector gave them, without what the tracker has learnt about their scale.
tracker::Matches<Printer, double> plain_matches(const PrinterTracker& tracker, bool shapes, Variances& variances) {
  constexpr double kQ24 = 1 << 24;
  auto matches = tracker.matches();
  const double f = tracker.camera().focal_px();
  for (std::size_t i = 0; i < kMarks; ++i) {
    variances[i].setZero();
    if (!matches[i].matched) continue;
    const auto& mark = tracker.detections()[static_cast<std::size_t>(matches[i].detection)];
    variances[i] << mark.centre_variance_q24 / kQ24, mark.axis_variance_q24 / kQ24;
    matches[i].variance = variances[i][0] / (f * f);
    matches[i].shape_variance = shapes ? variances[i][1] / (f * f) : 0;
  }
  return matches;
}

}  // namespace

/// 40 places of 50 frames, moved by half a pixel in all, so that every frame has its own places of pixels.
void shape(const Run& run, Table& table) {
  constexpr int kPlaces = 40;
  const CameraParameters camera = sim::PaperScenario::camera();
  test::Random random{run.seed};
  DrawerError tracked, with_shapes, centres;
  double centres_bound2 = 0, bound2 = 0;
  int frames = 0, missing = 0;
  std::vector<std::uint8_t> pixels;
  for (int place = 0; place < kPlaces; ++place) {
    if (place % 10 == 0) run.progress(fmt::format("place {} of {}", place, kPlaces));
    auto truth = configuration<Printer>(0.70, {random.uniform(-20, 20), 0, 0}, random.uniform(0.05, 0.15), 0.12);
    truth.T_cam_obj.t += Vec<double, 3>{random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), 0};
    const auto tracker = std::make_unique<PrinterTracker>(camera);
    tracker->set_start(truth);
    sim::Renderer renderer(camera, {.seed = run.seed + static_cast<std::uint64_t>(place)});
    const int in_place = std::max(1, run.part(2000) / kPlaces);
    for (int frame = 0; frame < in_place; ++frame, ++frames) {
      truth.T_cam_obj.t += Vec<double, 3>{0.7e-3, 0.4e-3, 0} / in_place;
      renderer.render(sim::scene_markers<Printer>(truth), static_cast<std::uint64_t>(frame), pixels);
      const auto estimate = tracker->step({pixels.data(), 640, 480, 640}, time_of(frame));
      if (!has_estimate(estimate) || estimate.matched < 6) {
        ++missing;
        continue;
      }
      tracked.add(truth, estimate.q);
      Variances variances;
      with_shapes.add(
          truth,
          tracker::solve<Printer, double>(plain_matches(*tracker, true, variances), {.mean = truth}, truth, 20).q);
      centres.add(
          truth,
          tracker::solve<Printer, double>(plain_matches(*tracker, false, variances), {.mean = truth}, truth, 20).q);
      bound2 += information<Printer>(truth, variances, 1, 0.005).inverse()(6, 6);
      for (auto& variance : variances) variance[1] = 0;
      centres_bound2 += information<Printer>(truth, variances).inverse()(6, 6);
    }
  }
  const int n = frames - missing;
  const double centres_bound_mm = 1e3 * std::sqrt(centres_bound2 / n), bound_mm = 1e3 * std::sqrt(bound2 / n);
  table.tell("bound of centres by the detector's variances, drawer", fmt::format("{:.4f} mm", centres_bound_mm));
  table.tell("bound of centres and shapes", fmt::format("{:.4f} mm", bound_mm));
  const auto rows = [&](const char* what, const DrawerError& error) {
    const double ratio = error.rms_mm() / centres_bound_mm;
    table.row(fmt::format("{}: drawer's RMS / bound of centres", what), "0.8", fmt::format("{:.3f}", ratio),
              ratio <= 0.8);
    table.row(fmt::format("{}: drawer's RMS (mean error)", what), "0.2 mm",
              fmt::format("{:.4f} mm ({:+.4f})", error.rms_mm(), error.mean_mm()), error.rms_mm() <= 0.2);
  };
  rows("tracker", tracked);
  rows("one solve, centres and shapes", with_shapes);
  table.tell("one solve, centres alone: RMS (mean error)",
             fmt::format("{:.4f} mm ({:+.4f})", centres.rms_mm(), centres.mean_mm()));
  table.tell("frames without all six marks matched", fmt::format("{} of {}", missing, frames));
}

}  // namespace articam::estimator_table
