/// @file  Is the covariance that is given out the errors' own?

#include <memory>
#include <vector>

#include "host_sim/world/renderer.hpp"
#include "tests/bench/estimator_table/printer_tracker.hpp"
#include "tests/bench/estimator_table/table.hpp"
#include "tests/support/random_views.hpp"

namespace articam::estimator_table {
namespace {

/// One frame each, nothing known before; every sheet of marks printed anew.
void single_frames(const Run& run, Table& table, const Noise& noise) {
  constexpr double kPrintScale = 0.005;
  const auto truth = nominal<FreePrinter>();
  test::Random random{run.seed};
  const int trials = run.part(10000);
  const Images unscaled = images_of<FreePrinter>(truth);
  double sum = 0;
  for (int trial = 0; trial < trials; ++trial) {
    // Off-centres depend on the size, too, but by nothing at this noise: with centres alone marks have their size.
    const Images images =
        noise.shape_px > 0 ? images_of<FreePrinter>(truth, std::exp(kPrintScale * random.gaussian())) : unscaled;
    const auto solution = tracker::solve<FreePrinter, double>(
        matches_of<FreePrinter, double>(observe(images, noise, random), noise), {.mean = truth}, truth, 20);
    const Vec8 error = model::difference<FreePrinter, double>(truth, solution.q);
    sum += error.dot(solution.covariance.ldlt().solve(error));
  }
  const double mean = sum / trials, band = 1.96 * std::sqrt(2.0 * kDof / trials);
  table.row(fmt::format("{} single frames, {} px, {}", trials, noise.centre_px,
                        noise.shape_px > 0 ? "centres and shapes" : "centres"),
            fmt::format("{:.2f}-{:.2f}", kDof - band, kDof + band), fmt::format("{:.2f}", mean),
            std::abs(mean - kDof) <= band);
}

/// What a sequence's estimates are worth: their mean normalised error, and how many there were.
struct Worth {
  double sum{};
  int estimates{}, frames{};
  void add(const PrinterEstimate& estimate, const PrinterConfiguration& truth) {
    ++frames;
    if (!has_estimate(estimate)) return;
    sum += normalised_error(estimate, truth), ++estimates;
  }
  double mean() const { return estimates > 0 ? sum / estimates : 0; }
  std::string words() const { return fmt::format("{:.2f}, of {} of {}", mean(), estimates, frames); }
  void row(Table& table, const std::string& what) const {
    table.row(what, "6.4-10, of all frames", words(),
              estimates == frames && mean() >= 0.8 * kDof && mean() <= 1.25 * kDof);
  }
};

/// The tracker over the paper's experiment, from true ellipses, after 20 s in which it learns the noise's scale.
void tracked_features(const Run& run, Table& table, const Noise& noise) {
  constexpr int kLearning = 600;
  const auto tracker = std::make_unique<PrinterTracker>(sim::PaperScenario::camera(), without_floor());
  test::Random random{run.seed};
  Worth worth;
  const int frames = kLearning + run.part(10000);
  for (int frame = 0; frame < frames; ++frame) {
    const auto truth = sim::PaperScenario::at(frame * kFrame_s).q;
    const auto marks = detections_of(observe(images_of<Printer>(truth), noise, random), noise);
    const auto estimate = tracker->step(marks, {}, time_of(frame));
    if (frame >= kLearning) worth.add(estimate, truth);
  }
  worth.row(table, fmt::format("tracker, exact marks, paper's motion, {} px, {}", noise.centre_px,
                               noise.shape_px > 0 ? "centres and shapes" : "centres"));
}

PrinterEstimate see(PrinterTracker& tracker, sim::Renderer& renderer, const PrinterConfiguration& truth, int frame,
                    std::vector<std::uint8_t>& pixels) {
  renderer.render(sim::scene_markers<Printer>(truth), static_cast<std::uint64_t>(frame), pixels);
  return tracker.step({pixels.data(), 640, 480, 640}, time_of(frame));
}

void rendered(const Run& run, Table& table) {
  const CameraParameters camera = sim::PaperScenario::camera();
  std::vector<std::uint8_t> pixels;
  run.progress("rendered, the paper's motion");
  {
    const auto tracker = std::make_unique<PrinterTracker>(camera);
    const auto no_floor = std::make_unique<PrinterTracker>(camera, without_floor());
    sim::Renderer renderer(camera, {.seed = run.seed});
    Worth worth, worth_without;
    for (int frame = 0; frame < run.part(2000); ++frame) {
      const auto truth = sim::PaperScenario::at(frame * kFrame_s).q;
      worth.add(see(*tracker, renderer, truth, frame, pixels), truth);
      worth_without.add(no_floor->step({pixels.data(), 640, 480, 640}, time_of(frame)), truth);
    }
    worth.row(table, "tracker, rendered frames, paper's motion, noise 4, blur 0.7");
    table.tell("the same with floor_px 0", worth_without.words());
  }
  run.progress("rendered, random views");
  test::Random random{run.seed};
  const vision::CameraModel<double> model{camera};
  constexpr int kViews = 10, kEarly = 100;
  Worth worth, late;
  for (int view = 0; view < kViews; ++view) {
    auto truth = test::random_view<Printer>(model, {.nearest_m = 0.5, .farthest_m = 1}, random);
    const auto tracker = std::make_unique<PrinterTracker>(camera);
    tracker->set_start(truth);
    sim::Renderer renderer(camera, {.seed = run.seed + static_cast<std::uint64_t>(view)});
    for (int frame = 0; frame < run.part(2000) / kViews; ++frame) {
      truth.T_cam_obj.t += Vec<double, 3>{0.0002, 0.00015, 0.0001};  // 8 mm/s: each frame has its own places of pixels
      const auto estimate = see(*tracker, renderer, truth, frame, pixels);
      worth.add(estimate, truth);
      if (frame >= kEarly) late.add(estimate, truth);
    }
  }
  worth.row(table, fmt::format("tracker, rendered frames, {} random views that move slowly", kViews));
  table.tell("the same without the first 100 frames of each", late.words());
}

}  // namespace

void nees(const Run& run, Table& table) {
  for (const double noise_px : {0.02, 0.1}) {
    for (const double shape_px : {0.0, noise_px}) {
      run.progress(fmt::format("single frames and tracked, {} px, shapes {} px", noise_px, shape_px));
      single_frames(run, table, {noise_px, shape_px});
      tracked_features(run, table, {noise_px, shape_px});
    }
  }
  rendered(run, table);
}

}  // namespace articam::estimator_table
