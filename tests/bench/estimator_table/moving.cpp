/// @file  A drawer that moves: how far behind is the estimate, and how far off?

#include <memory>
#include <numbers>
#include <vector>

#include "host_sim/report/line_fit.hpp"
#include "tests/bench/estimator_table/printer_tracker.hpp"
#include "tests/bench/estimator_table/table.hpp"

namespace articam::estimator_table {
namespace {

using sim::JointMotion;

constexpr double kSpeed_m_s = 0.05;
constexpr Noise kNoise{0.02, 0};

/// To and fro between 20 and 140 mm at 50 mm/s; it turns within 0.2 s.
JointMotion steady(double t_s) {
  constexpr double kRamp_s = 0.1, kWay_m = 0.12, kStroke_s = kWay_m / kSpeed_m_s + kRamp_s;
  const double strokes = std::floor(t_s / kStroke_s), t = t_s - strokes * kStroke_s, left = kStroke_s - t;
  const bool back = std::fmod(strokes, 2) > 0.5;
  double way = kSpeed_m_s * (t - 0.5 * kRamp_s), speed = kSpeed_m_s;
  if (t < kRamp_s) way = 0.5 * kSpeed_m_s / kRamp_s * t * t, speed = kSpeed_m_s * t / kRamp_s;
  if (left < kRamp_s) way = kWay_m - 0.5 * kSpeed_m_s / kRamp_s * left * left, speed = kSpeed_m_s * left / kRamp_s;
  return {back ? 0.14 - way : 0.02 + way, back ? -speed : speed};
}

/// 50 mm/s at most, once in 4 s.
JointMotion sinusoid(double t_s) {
  constexpr double kRate_per_s = 2 * std::numbers::pi / 4;
  return {0.08 + kSpeed_m_s / kRate_per_s * std::sin(kRate_per_s * t_s), kSpeed_m_s * std::cos(kRate_per_s * t_s)};
}

struct Case {
  const char* name;
  double readout_s;  ///< of the true camera
  bool told;         ///< so says the camera file
  tracker::Options options;
  bool asked;
};

PrinterConfiguration at(double t_s, JointMotion (*motion)(double)) {
  auto q = nominal<Printer>();
  q.joints[0] = motion(t_s).position;
  return q;
}

/// The frame's time is mid-exposure of its first row; each mark is seen when its centre's row is.
Images rolling_images(double t_s, double readout_s, JointMotion (*motion)(double)) {
  Images images = images_of<Printer>(at(t_s, motion));
  if (!(readout_s > 0)) return images;
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < kMarks; ++i) {
      const double row_s = readout_s * images[i][1] / 479;
      images[i] = images_of<Printer>(at(t_s + row_s, motion))[i];
    }
  }
  return images;
}

void follow(const Run& run, Table& table, const Case& setting, const char* motion_name, JointMotion (*motion)(double)) {
  constexpr int kLearning = 600;
  constexpr std::size_t kReach = 30;  // a second: what a filter may remember
  CameraParameters camera = sim::PaperScenario::camera();
  if (setting.told) camera.readout_time_s = setting.readout_s;
  const auto tracker = std::make_unique<PrinterTracker>(camera, setting.options);
  tracker->set_start(at(0, motion));
  test::Random random{run.seed};
  std::vector<double> errors, velocities;
  double sum2 = 0, rate_sum2 = 0;
  int missing = 0;
  const int frames = kLearning + run.part(6000);
  for (int frame = 0; frame < frames; ++frame) {
    const double t_s = frame * kFrame_s;
    const Images seen = observe(rolling_images(t_s, setting.readout_s, motion), kNoise, random);
    const auto estimate = tracker->step(detections_of(seen, kNoise), {}, time_of(frame));
    if (frame < kLearning) continue;
    const JointMotion truth = motion(t_s);
    missing += estimate.valid ? 0 : 1;
    errors.push_back(estimate.q.joints[0] - truth.position);
    velocities.push_back(truth.velocity);
    sum2 += errors.back() * errors.back();
    rate_sum2 += (estimate.qdot[6] - truth.velocity) * (estimate.qdot[6] - truth.velocity);
  }
  const auto n = static_cast<double>(errors.size());
  const double rms_mm = 1e3 * std::sqrt(sum2 / n), rate_rms_mm = 1e3 * std::sqrt(rate_sum2 / n);
  const auto fit = sim::fit_line(velocities, errors, kReach);
  const auto [slope, low, high] = fit.slope_interval();
  const auto what = fmt::format("{}, {}", motion_name, setting.name);
  const auto rms = fmt::format("{:.3f} mm", rms_mm);
  const auto lag = fmt::format("{:.3f} ms ({:.3f} to {:.3f})", -1e3 * slope, -1e3 * high, -1e3 * low);
  if (setting.asked) {
    table.row(what + ": RMS", "0.15 mm", rms, rms_mm <= 0.15 && missing == 0);
    table.row(what + ": lag, 95 % interval", "1 ms", lag, low > -1e-3 && high < 1e-3);
  } else {
    table.tell(what + ": RMS, lag", rms + ", " + lag);
  }
  table.tell("its rate's RMS error, frames without an estimate", fmt::format("{:.2f} mm/s, {}", rate_rms_mm, missing));
}

}  // namespace

void moving(const Run& run, Table& table) {
  constexpr double kReadout_s = 0.015;
  tracker::Options standard = without_floor(), paper = standard;
  paper.mode = tracker::Mode::paper;
  tracker::Options forward = paper;
  forward.feed_forward = true;
  const Case cases[] = {
      {"all rows at once", 0, false, standard, true},
      {"rolling shutter 15 ms", kReadout_s, true, standard, true},
      {"rolling shutter 15 ms, the camera file does not say so", kReadout_s, false, standard, false},
      {"paper", 0, false, paper, false},
      {"paper with feed-forward", 0, false, forward, false},
      {"paper, rolling shutter 15 ms", kReadout_s, true, paper, false},
      {"paper with feed-forward, rolling shutter 15 ms", kReadout_s, true, forward, false},
  };
  for (const Case& setting : cases) {
    run.progress(setting.name);
    follow(run, table, setting, "50 mm/s", steady);
    follow(run, table, setting, "sinusoid", sinusoid);
  }
}

}  // namespace articam::estimator_table
