#include "hal/app/replay_job.hpp"

#include <algorithm>
#include <cmath>

namespace articam::app {
namespace {

/// The value below which a share of them lies, the nearest one; 0 of none. As in host_sim/report/metrics.cpp.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<std::size_t>(k)];
}

}  // namespace

std::string create_folder(const std::string& path) {
  std::error_code error;
  if (!path.empty()) std::filesystem::create_directories(path, error);
  return error ? path + ": " + error.message() : std::string{};
}

void Summary::add(tracker::TrackingStatus status, double rms_px, int matched, double step_s,
                  std::vector<double> joints) {
  ++statuses_[static_cast<std::size_t>(status)];
  step_s_.push_back(step_s);
  if (matched > 0) rms_px_.push_back(rms_px);
  const bool good = status == tracker::TrackingStatus::tracking || status == tracker::TrackingStatus::degraded;
  if (good) joints_.push_back(std::move(joints));
}

std::string Summary::text(const std::vector<std::string>& joint_names, double rate_hz) const {
  const double all = static_cast<double>(step_s_.size());
  std::string text = fmt::format("frames       {}\n", step_s_.size());
  for (std::size_t i = 0; i < statuses_.size(); ++i) {
    if (statuses_[i] == 0) continue;
    text += fmt::format("{:<12} {} ({:.1f} %)\n", name(static_cast<tracker::TrackingStatus>(i)), statuses_[i],
                        100 * static_cast<double>(statuses_[i]) / all);
  }
  text +=
      fmt::format("rms          median {:.3f} px, 95 % {:.3f} px\n", quantile(rms_px_, 0.5), quantile(rms_px_, 0.95));
  text += fmt::format("step         median {:.3f} ms, 99 % {:.3f} ms, of {:.1f} ms a frame\n",
                      1e3 * quantile(step_s_, 0.5), 1e3 * quantile(step_s_, 0.99), 1e3 / rate_hz);
  for (std::size_t j = 0; j < joint_names.size(); ++j) {
    std::vector<double> values;
    for (const auto& joints : joints_) values.push_back(joints[j]);
    text += fmt::format("{:<12} median {:.5f}, 5 % {:.5f}, 95 % {:.5f}\n", joint_names[j], quantile(values, 0.5),
                        quantile(values, 0.05), quantile(values, 0.95));
  }
  return text;
}

void show_progress(std::size_t done, std::size_t all) {
  constexpr std::size_t kWidth = 40;
  if (done % 10 != 0 && done != all) return;
  const std::size_t filled = kWidth * done / all;
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}/{}{}", "", filled, "", kWidth - filled, done, all, done == all ? "\n" : "");
}

}  // namespace articam::app
