#include "tools/report/observability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace articam::report {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A view with what it shows.
struct Looked {
  std::vector<Sight> sights;
  Information known;
  Bound all;
};

Looked look_at_all(const modelgen::Table& table, const View& view, const Conditions& conditions) {
  Looked looked{look(table, view, conditions.camera), {}, {}};
  looked.known = information(looked.sights);
  looked.all = bound(looked.known, known_beforehand(table), conditions.noise_px);
  return looked;
}

Freedom judge(const std::vector<Looked>& looked, std::size_t i, const std::string& name, bool metres) {
  Freedom freedom{name, metres, 0, 0, kNaN, kNaN, 0, 0};
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

std::vector<bool> all_but(const modelgen::Table& table, std::size_t m) {
  std::vector<bool> use(table.markers.size(), true);
  use[m] = false;
  return use;
}

/// How often, and why not, a mark is seen.
void count_sightings(const std::vector<Looked>& looked, std::size_t m, Loss& loss) {
  const double one = 1 / static_cast<double>(looked.size());
  for (const Looked& view : looked) {
    switch (view.sights[m].sighting) {
      case Sighting::seen:
        loss.share_seen += one;
        break;
      case Sighting::outside_picture:
        loss.share_outside_picture += one;
        break;
      case Sighting::turned_away:
        loss.share_turned_away += one;
        break;
      case Sighting::too_small:
        loss.share_too_small += one;
        break;
    }
  }
}

/// The degree of freedom whose deviation grows most, where it is observed with and without.
void find_growth(const std::vector<std::string>& names, const std::vector<std::vector<double>>& growth, Loss& loss) {
  for (std::size_t i = names.size() > 6 ? 6 : 0; i < names.size(); ++i) {  // joints are what it is about
    const double factor = median(growth[i]);
    if (!(factor > loss.growth)) continue;
    loss.growth = factor;
    loss.worst_grown = names[i];
  }
}

Loss judge_loss(const modelgen::Table& table, const std::vector<Looked>& looked, std::size_t m, double noise_px) {
  const std::vector<std::string> names = freedom_names(table);
  const std::vector<bool> without = all_but(table, m);
  const VectorX beforehand = known_beforehand(table);
  Loss loss;
  loss.marker = table.markers[m].name;
  count_sightings(looked, m, loss);
  std::vector<Blinded> counts(names.size());
  std::vector<std::vector<double>> growth(names.size());
  std::vector<double> singular;
  for (const Looked& view : looked) {
    if (!view.sights[m].seen()) continue;
    const Information known = information(view.sights, without);
    const Bound rest = bound(known, beforehand, noise_px);
    singular.push_back(least_singular_px(known, table));
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!view.all.observed[i]) continue;
      ++counts[i].num_with;
      if (!rest.observed[i]) continue;
      ++counts[i].num_without;
      const auto at = static_cast<Eigen::Index>(i);
      growth[i].push_back(rest.deviation[at] / view.all.deviation[at]);
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    counts[i].name = names[i];
    counts[i].is_of_base = i < 6;
    if (counts[i].num_without < counts[i].num_with) loss.blinded.push_back(counts[i]);
  }
  find_growth(names, growth, loss);
  if (!singular.empty()) loss.least_singular_px = median(singular);
  return loss;
}

/// What is observed at q0 with the mark and not without.
std::vector<std::string> lost_at_start(const modelgen::Table& table, const Looked& start, std::size_t m,
                                       double noise_px) {
  const Bound rest = bound(information(start.sights, all_but(table, m)), known_beforehand(table), noise_px);
  const std::vector<std::string> names = freedom_names(table);
  std::vector<std::string> lost;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (start.all.observed[i] && !rest.observed[i]) lost.push_back(names[i]);
  }
  return lost;
}

/// Over all views: how many are complete, and how the worst seen direction fares.
void summarise(const modelgen::Table& table, const std::vector<Looked>& looked, Observability& result) {
  std::vector<double> singular;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < looked.size(); ++v) {
    singular.push_back(least_singular_px(looked[v].known, table));
    if (!looked[v].all.complete()) continue;
    result.share_complete += 1 / static_cast<double>(looked.size());
    if (singular.back() >= least) continue;
    least = singular.back();
    result.least_singular_view = v;
  }
  result.median_singular_px = median(singular);
  result.least_singular_px = std::isfinite(least) ? least : 0;
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

Observability observe(const modelgen::Table& table, const std::vector<View>& views, const View* start,
                      const Conditions& conditions, Says says) {
  std::vector<Looked> looked;
  for (const View& view : views) looked.push_back(look_at_all(table, view, conditions));
  const std::vector<std::string> names = freedom_names(table);
  Observability result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    result.freedoms.push_back(judge(looked, i, names[i], is_metres(table, i)));
  }
  summarise(table, looked, result);
  std::optional<Looked> at_start;
  if (start != nullptr) at_start = look_at_all(table, *start, conditions);
  for (std::size_t m = 0; m < table.markers.size(); ++m) {
    if (!is_mark(table.markers[m])) continue;
    says("what is observed", static_cast<double>(m) / static_cast<double>(table.markers.size()));
    result.losses.push_back(judge_loss(table, looked, m, conditions.noise_px));
    if (at_start) result.losses.back().at_start = lost_at_start(table, *at_start, m, conditions.noise_px);
  }
  return result;
}

}  // namespace articam::report
