#include "tools/report/placement.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

namespace articam::report {
namespace {

using modelgen::Table;
using modelgen::TableMarker;

/// The model at the middle of its joints' ranges.
struct Layout {
  Marks marks;
  std::vector<Pose<double>> T_obj_body;
  Vec3 normal;        ///< mean of the marks'
  TableMarker usual;  ///< of the kind and size that most marks have

  Pose<double> pose(int body) const { return body < 0 ? Pose<double>{} : T_obj_body[static_cast<std::size_t>(body)]; }
};

Layout layout_of(const Table& table) {
  const VectorX joints = joints_at(table, 0.5);
  Layout layout{place_marks(table, joints), place_bodies(table, joints), {}, {}};
  layout.normal = front_of(table, layout.marks).normal;
  std::map<std::tuple<model::MarkerKind, double, double>, int> counts;
  int most = 0;
  for (std::size_t m = 0; m < table.markers.size(); ++m) {
    const TableMarker& marker = table.markers[m];
    if (!is_mark(marker)) continue;
    const int count = ++counts[{marker.kind, marker.outer_diameter_m, marker.inner_diameter_m}];
    if (count <= most) continue;
    most = count;
    layout.usual = marker;
  }
  return layout;
}

/// Largest distance of two marks of a body, or of all for body kAll.
constexpr int kAll = -2;
double extent_of(const Table& table, const Layout& layout, int body) {
  double extent_m = 0;
  for (std::size_t m = 0; m < table.markers.size(); ++m) {
    for (std::size_t k = 0; k < m; ++k) {
      const auto counts = [&](const TableMarker& mark) { return is_mark(mark) && (body == kAll || mark.body == body); };
      if (!counts(table.markers[m]) || !counts(table.markers[k])) continue;
      extent_m = std::max(extent_m, (layout.marks.centre[m] - layout.marks.centre[k]).norm());
    }
  }
  return extent_m;
}

/// Where the pattern of a body is centred, and which way its marks face, in the body's frame.
struct Anchor {
  Vec3 place{Vec3::Zero()}, normal;
};

Anchor anchor_of(const Table& table, const Layout& layout, int body) {
  Anchor anchor;
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const TableMarker& marker : table.markers) {
    if (marker.body != body || !is_mark(marker)) continue;
    anchor.place += marker.t_body_m;
    sum += marker.normal;
    ++count;
  }
  if (count > 0) anchor.place /= count;
  anchor.normal = sum.norm() > 0.1 ? Vec3(sum.normalized()) : Vec3(layout.pose(body).R.conjugate() * layout.normal);
  return anchor;
}

/// Eight directions in the plane of the marks at three distances, and a step out of it either way.
std::vector<Vec3> pattern(const Anchor& anchor, double extent_m) {
  const Vec3 x = perpendicular(anchor.normal), y = anchor.normal.cross(x);
  std::vector<Vec3> places;
  for (const double share : {0.25, 0.5, 1.0}) {
    for (int i = 0; i < 8; ++i) {
      const double angle = i * std::numbers::pi / 4;
      places.emplace_back(anchor.place + share * extent_m * (std::cos(angle) * x + std::sin(angle) * y));
    }
  }
  for (const double share : {-0.25, 0.25}) places.emplace_back(anchor.place + share * extent_m * anchor.normal);
  return places;
}

/// As a link's mark would be written in the URDF.
Candidate on_link(const Table& table, const TableMarker& mark) {
  Candidate candidate{table.root_link, "", mark.t_body_m, mark.normal, mark};
  if (mark.body < 0) return candidate;
  const auto& joint = table.joints[static_cast<std::size_t>(mark.body)];
  const Pose<double> T_link_body = joint.T_body_link.inverse();
  candidate.link = joint.child_link;
  candidate.place = T_link_body * mark.t_body_m;
  candidate.normal = T_link_body.R * mark.normal;
  return candidate;
}

bool is_free(const Table& table, const Layout& layout, const Candidate& candidate) {
  const Vec3 place = layout.pose(candidate.mark.body) * candidate.mark.t_body_m;
  for (std::size_t m = 0; m < table.markers.size(); ++m) {
    const double least_m = 1.5 * layout.usual.outer_diameter_m;
    if (is_mark(table.markers[m]) && (layout.marks.centre[m] - place).norm() < least_m) return false;
  }
  return true;
}

/// Every seventh view: that goes through all directions, whose number is no multiple of it.
std::vector<View> some_of(const std::vector<View>& views) {
  std::vector<View> some;
  for (std::size_t i = 0; i < views.size(); i += 7) some.push_back(views[i]);
  return some;
}

Table with_mark(const Table& table, const Candidate& candidate) {
  Table more = table;
  more.markers.push_back(candidate.mark);
  return more;
}

/// What is compared: the mean logarithm of all joints' deviations (of the base's, without joints), the knowledge of
/// beforehand included.
double log_deviation(const VectorX& variances) {
  const Eigen::Index n = variances.size(), first = n > 6 ? 6 : 0;
  return 0.5 * variances.tail(n - first).array().log().mean();
}

/// Variances with one more mark, whose rows of A are in units of the noise: those without, less what it tells (the
/// matrix inversion lemma: a mark is of rank two, so no matrix need be inverted anew).
VectorX with_rows(const MatrixX& covariance, const Eigen::Matrix<double, 2, Eigen::Dynamic>& rows) {
  const Eigen::Matrix<double, Eigen::Dynamic, 2> gain = covariance * rows.transpose();
  const Eigen::Matrix2d innovation = Eigen::Matrix2d::Identity() + rows * gain;
  const VectorX less = (gain * innovation.inverse()).cwiseProduct(gain).rowwise().sum();
  return (covariance.diagonal() - less).cwiseMax(std::numeric_limits<double>::min());  // whatever rounding leaves
}

/// Of every candidate, what it gains, see Advice.
std::vector<double> gains_of(const Table& table, const std::vector<Candidate>& all, const std::vector<View>& views,
                             const Conditions& conditions) {
  Table places = table;  // the candidates as marks of one model: seen all at once
  places.markers.clear();
  for (const Candidate& candidate : all) places.markers.push_back(candidate.mark);
  const MatrixX beforehand = known_beforehand(table).cwiseAbs2().cwiseInverse().asDiagonal();
  std::vector<double> logs(all.size());
  const std::vector<View> some = some_of(views);
  for (const View& view : some) {
    const MatrixX known = information(look(table, view, conditions.camera)).sum_px2;
    const MatrixX I = known / (conditions.noise_px * conditions.noise_px) + beforehand;
    const MatrixX covariance = I.ldlt().solve(MatrixX::Identity(I.rows(), I.cols()));
    const double without = log_deviation(covariance.diagonal());
    const std::vector<Sight> sights = look(places, view, conditions.camera);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!sights[i].seen()) continue;
      logs[i] += without - log_deviation(with_rows(covariance, sights[i].A / conditions.noise_px));
    }
  }
  for (double& gain : logs) gain = std::exp(gain / static_cast<double>(some.size()));
  return logs;
}

std::vector<Effect> effects_of(const Table& table, const Candidate& candidate, const std::vector<View>& views,
                               const Conditions& conditions) {
  const Table more = with_mark(table, candidate);
  const VectorX beforehand = known_beforehand(table);
  const std::vector<std::string> names = freedom_names(table);
  const std::size_t first = names.size() > 6 ? 6 : 0;
  std::vector<Effect> effects;
  for (std::size_t i = first; i < names.size(); ++i) effects.push_back({names[i], is_metres(table, i), 0, 0, 0, 0});
  std::vector<std::vector<double>> without(effects.size()), with(effects.size());
  for (const View& view : views) {
    const auto bound_of = [&](const Table& marked) {
      return bound(information(look(marked, view, conditions.camera)), beforehand, conditions.noise_px);
    };
    const Bound before = bound_of(table), after = bound_of(more);
    for (std::size_t k = 0; k < effects.size(); ++k) {
      const double one = 1 / static_cast<double>(views.size());
      effects[k].share_without += before.observed[first + k] ? one : 0;
      effects[k].share_with += after.observed[first + k] ? one : 0;
      if (!before.observed[first + k] || !after.observed[first + k]) continue;
      without[k].push_back(before.deviation[static_cast<Eigen::Index>(first + k)]);
      with[k].push_back(after.deviation[static_cast<Eigen::Index>(first + k)]);
    }
  }
  for (std::size_t k = 0; k < effects.size(); ++k) {
    effects[k].median_without = median(without[k]);
    effects[k].median_with = median(with[k]);
  }
  return effects;
}

}  // namespace

std::vector<Candidate> candidates(const Table& table) {
  const Layout layout = layout_of(table);
  std::vector<Candidate> result;
  const auto add = [&](int body, const Vec3& place, const Vec3& normal, const std::string& point) {
    TableMarker mark = layout.usual;
    mark.name = "one_more";
    mark.body = body;
    mark.t_body_m = place;
    mark.normal = normal;
    result.push_back(on_link(table, mark));
    result.back().point = point;
  };
  for (const TableMarker& marker : table.markers) {
    if (!is_mark(marker)) add(marker.body, marker.t_body_m, marker.normal, marker.name);
  }
  for (int body = -1; body < static_cast<int>(table.joints.size()); ++body) {
    const Anchor anchor = anchor_of(table, layout, body);
    const double own_m = extent_of(table, layout, body);
    const double extent_m = own_m > 0 ? own_m : 0.5 * extent_of(table, layout, kAll);
    for (const Vec3& place : pattern(anchor, extent_m)) add(body, place, anchor.normal, "");
  }
  std::erase_if(result, [&](const Candidate& c) { return !is_free(table, layout, c); });
  return result;
}

std::vector<Advice> advise(const Table& table, const std::vector<View>& views, const Conditions& conditions,
                           std::size_t count, Says says) {
  const std::vector<Candidate> places = candidates(table);
  const std::vector<double> gains = gains_of(table, places, views, conditions);
  std::vector<Advice> all;
  for (std::size_t i = 0; i < places.size(); ++i) all.push_back({places[i], {}, gains[i]});
  std::stable_sort(all.begin(), all.end(), [](const Advice& a, const Advice& b) { return a.gain > b.gain; });
  std::vector<Advice> best;
  for (const Advice& advice : all) {
    const auto same_body = [&](const Advice& b) { return b.candidate.mark.body == advice.candidate.mark.body; };
    if (std::any_of(best.begin(), best.end(), same_body)) continue;
    says("places for one more mark", static_cast<double>(best.size()) / static_cast<double>(count));
    best.push_back(advice);
    best.back().effects = effects_of(table, advice.candidate, views, conditions);
    if (best.size() == count) break;
  }
  return best;
}

}  // namespace articam::report
