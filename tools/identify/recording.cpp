#include "tools/identify/recording.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace articam::identify {
namespace {

/// Root mean square way of the marks that both moments saw.
double way_px(const Moment& from, const Moment& to) {
  double sum = 0;
  int shared = 0;
  for (const Sighting& a : from.sightings) {
    for (const Sighting& b : to.sightings) {
      if (a.marker != b.marker) continue;
      sum += (a.pixel - b.pixel).squaredNorm();
      ++shared;
    }
  }
  return shared == 0 ? 0.0 : std::sqrt(sum / shared);
}

double quantile(std::vector<double> values, double share) {
  const auto k = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), k, values.end());
  return *k;
}

}  // namespace

Recording spread_out(const Recording& recording, std::size_t most) {
  if (recording.size() <= most) return recording;
  std::vector<double> way{0};
  for (std::size_t i = 1; i < recording.size(); ++i) way.push_back(way.back() + way_px(recording[i - 1], recording[i]));
  const double all = std::max(way.back(), 1e-9), moments = static_cast<double>(recording.size());
  Recording chosen;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const double place = 0.5 * (way[i] / all + static_cast<double>(i + 1) / moments);  // up to 1
    if (place * static_cast<double>(most) > static_cast<double>(chosen.size()) && chosen.size() < most)
      chosen.push_back(recording[i]);
  }
  return chosen;
}

void mind_repetition(Recording& recording) {
  constexpr double kPlaces = 2;  // in a pixel
  const auto place = [](const Sighting& sighting) {
    return std::tuple{sighting.marker, std::floor(kPlaces * sighting.pixel.x()),
                      std::floor(kPlaces * sighting.pixel.y())};
  };
  std::map<std::tuple<std::size_t, double, double>, int> times;
  for (const Moment& moment : recording) {
    for (const Sighting& sighting : moment.sightings) ++times[place(sighting)];
  }
  for (Moment& moment : recording) {
    for (Sighting& sighting : moment.sightings) sighting.variance_px2 += times[place(sighting)] * sighting.bias_px2;
  }
}

std::vector<int> find_still(const Recording& recording, const std::vector<bool>& slides) {
  constexpr double kSlide_m = 0.001, kTurn_rad = 0.0087;
  std::vector<int> still;
  for (std::size_t j = 0; !recording.empty() && j < slides.size(); ++j) {
    std::vector<double> values, deviations;
    for (const Moment& moment : recording) {
      values.push_back(moment.joints[j]);
      deviations.push_back(moment.joint_deviations[j]);
    }
    const double range = quantile(values, 0.95) - quantile(values, 0.05);
    if (range < 3.3 * quantile(deviations, 0.5) + (slides[j] ? kSlide_m : kTurn_rad))
      still.push_back(static_cast<int>(j));
  }
  return still;
}

}  // namespace articam::identify
