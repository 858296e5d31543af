#include "tools/report/observability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace articam::report {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Every view with what it shows.
struct Looked {
  std::vector<Sight> sights;
  Bound all;
};

std::vector<Looked> look_everywhere(const modelgen::Table& table, const std::vector<View>& views,
                                    const Conditions& conditions) {
  std::vector<Looked> looked;
  for (const View& view : views) {
    Looked one{look(table, view, conditions.camera), {}};
    one.all = bound(one.sights, conditions.noise_px);
    looked.push_back(std::move(one));
  }
  return looked;
}

Freedom judge(const std::vector<Looked>& looked, std::size_t i, const std::string& name, bool is_metres) {
  Freedom freedom{name, is_metres, 0, 0, kNaN, kNaN, 0, 0};
  std::vector<double> deviations;
  const auto at = static_cast<Eigen::Index>(i);
  for (std::size_t v = 0; v < looked.size(); ++v) {
    const Bound& all = looked[v].all;
    if (!all.observed[i]) continue;
    deviations.push_back(all.deviation[at]);
    if (all.dilution[at] > kWeakDilution) freedom.share_weak += 1;
    if (all.dilution[at] > freedom.worst_dilution) {
      freedom.worst_dilution = all.dilution[at];
      freedom.worst_view = v;
    }
  }
  const auto views = static_cast<double>(looked.size());
  freedom.share_observed = static_cast<double>(deviations.size()) / views;
  freedom.share_weak /= views;
  if (!deviations.empty()) freedom.worst = *std::max_element(deviations.begin(), deviations.end());
  freedom.median = median(deviations);
  return freedom;
}

Loss judge_loss(const modelgen::Table& table, const std::vector<Looked>& looked, std::size_t m, double noise_px) {
  const std::vector<std::string> names = freedom_names(table);
  Loss loss{table.markers[m].name, 0, {}, "", 1};
  std::vector<bool> without(table.markers.size(), true);
  without[m] = false;
  std::vector<double> blinded(names.size());
  std::vector<std::vector<double>> growth(names.size());
  for (const Looked& view : looked) {
    if (!view.sights[m].seen) continue;
    ++loss.num_views;
    const Bound rest = bound(view.sights, without, noise_px);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!view.all.observed[i]) continue;
      const auto at = static_cast<Eigen::Index>(i);
      if (!rest.observed[i]) {
        blinded[i] += 1;
      } else {
        growth[i].push_back(rest.deviation[at] / view.all.deviation[at]);
      }
    }
  }
  const std::size_t first = names.size() > 6 ? 6 : 0;  // joints are what it is about
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_blinded = 2 * blinded[i] > static_cast<double>(loss.num_views);
    if (is_blinded) loss.blinded.push_back(names[i]);
    const double factor = median(growth[i]);
    if (is_blinded || i < first || !(factor > loss.growth)) continue;
    loss.growth = factor;
    loss.worst_grown = names[i];
  }
  return loss;
}

}  // namespace

double median(std::vector<double> numbers) {
  if (numbers.empty()) return kNaN;
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

std::vector<std::string> freedom_names(const modelgen::Table& table) {
  std::vector<std::string> names{"tx", "ty", "tz", "rx", "ry", "rz"};
  for (const auto* joint : table.values()) names.push_back(joint->name);
  return names;
}

Observability observe(const modelgen::Table& table, const std::vector<View>& views, const Conditions& conditions) {
  const std::vector<Looked> looked = look_everywhere(table, views, conditions);
  const std::vector<std::string> names = freedom_names(table);
  const auto values = table.values();
  Observability result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_metres = i < 3 || (i >= 6 && values[i - 6]->kind == model::JointKind::prismatic);
    result.freedoms.push_back(judge(looked, i, names[i], is_metres));
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < looked.size(); ++v) {
    const Bound& all = looked[v].all;
    if (!std::all_of(all.observed.begin(), all.observed.end(), [](bool b) { return b; })) continue;
    result.share_complete += 1 / static_cast<double>(looked.size());
    const double here = least_singular_px(looked[v].sights, table);
    if (here >= least) continue;
    least = here;
    result.least_singular_view = v;
  }
  result.least_singular_px = std::isfinite(least) ? least : 0;
  for (std::size_t m = 0; m < table.markers.size(); ++m) {
    if (table.markers[m].kind == model::MarkerKind::point) continue;
    result.losses.push_back(judge_loss(table, looked, m, conditions.noise_px));
  }
  return result;
}

}  // namespace articam::report
