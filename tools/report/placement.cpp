#include "tools/report/placement.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace articam::report {
namespace {

using modelgen::Table;
using modelgen::TableMarker;

bool is_mark(const TableMarker& marker) { return marker.kind != model::MarkerKind::point; }

/// Of the marks at the middle of the joints' ranges: how far they are apart, their mean normal, their largest size.
struct Layout {
  double extent_m{0.1};
  Vec3 normal{-Vec3::UnitZ()};
  double diameter_m{0.05};
  std::vector<Pose<double>> T_obj_body;
};

VectorX middle_joints(const Table& table) {
  const auto values = table.values();
  VectorX joints(static_cast<Eigen::Index>(values.size()));
  for (std::size_t j = 0; j < values.size(); ++j) {
    joints[static_cast<Eigen::Index>(j)] = 0.5 * (low_limit(*values[j]) + high_limit(*values[j]));
  }
  return joints;
}

Layout layout_of(const Table& table) {
  const VectorX joints = middle_joints(table);
  const Marks marks = place_marks(table, joints);
  Layout layout;
  layout.T_obj_body = place_bodies(table, joints);
  Vec3 sum = Vec3::Zero();
  for (std::size_t m = 0; m < table.markers.size(); ++m) {
    if (!is_mark(table.markers[m])) continue;
    sum += marks.normal[m];
    layout.diameter_m = std::max(layout.diameter_m, table.markers[m].outer_diameter_m);
    for (std::size_t k = 0; k < m; ++k) {
      if (!is_mark(table.markers[k])) continue;
      layout.extent_m = std::max(layout.extent_m, (marks.centre[m] - marks.centre[k]).norm());
    }
  }
  if (sum.norm() > 0.1) layout.normal = sum.normalized();
  return layout;
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
  const Pose<double> T = body < 0 ? Pose<double>{} : layout.T_obj_body[static_cast<std::size_t>(body)];
  anchor.normal = sum.norm() > 0.1 ? Vec3(sum.normalized()) : Vec3(T.R.conjugate() * layout.normal);
  return anchor;
}

Vec3 perpendicular(const Vec3& n) {
  const Vec3 axis = std::abs(n.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  return (axis - axis.dot(n) * n).normalized();
}

/// Eight directions in the plane of the marks at three distances, and a step out of it either way.
std::vector<Vec3> pattern(const Anchor& anchor, double extent_m) {
  const Vec3 x = perpendicular(anchor.normal), y = anchor.normal.cross(x);
  std::vector<Vec3> places;
  for (const double share : {0.25, 0.5, 1.0}) {
    for (int i = 0; i < 8; ++i) {
      const double angle = i * 0.25 * 3.14159265358979;
      places.emplace_back(anchor.place + share * extent_m * (std::cos(angle) * x + std::sin(angle) * y));
    }
  }
  for (const double share : {-0.25, 0.25}) places.emplace_back(anchor.place + share * extent_m * anchor.normal);
  return places;
}

/// As a link's mark would be written in the URDF.
Candidate on_link(const Table& table, int body, const Vec3& place, const Vec3& normal) {
  Pose<double> T_link_body;
  Candidate candidate;
  candidate.link = table.root_link;
  if (body >= 0) {
    const auto& joint = table.joints[static_cast<std::size_t>(body)];
    candidate.link = joint.child_link;
    T_link_body = joint.T_body_link.inverse();
  }
  candidate.place = T_link_body * place;
  candidate.normal = T_link_body.R * normal;
  candidate.body = body;
  candidate.t_body_m = place;
  candidate.normal_body = normal;
  return candidate;
}

bool is_free(const Table& table, const Candidate& candidate, double diameter_m) {
  return std::none_of(table.markers.begin(), table.markers.end(), [&](const TableMarker& marker) {
    return is_mark(marker) && marker.body == candidate.body &&
           (marker.t_body_m - candidate.t_body_m).norm() < 1.5 * diameter_m;
  });
}

TableMarker to_marker(const Candidate& candidate, double diameter_m) {
  return {"candidate", model::MarkerKind::ring, candidate.body, candidate.t_body_m, candidate.normal_body,
          diameter_m,  0.4 * diameter_m};
}

/// Every fifth view: places that differ do so in all of them, and there are many places.
std::vector<View> some_of(const std::vector<View>& views) {
  std::vector<View> some;
  for (std::size_t i = 0; i < views.size(); i += 5) some.push_back(views[i]);
  return some;
}

/// What is known beforehand: a joint lies within its limits, the object within some metres.
VectorX prior_information(const Table& table) {
  const auto values = table.values();
  VectorX prior = VectorX::Constant(6 + static_cast<Eigen::Index>(values.size()), 0.01);  // 10 m, 10 rad
  for (std::size_t j = 0; j < values.size(); ++j) {
    const double quarter = std::max(0.25 * (high_limit(*values[j]) - low_limit(*values[j])), 1e-6);
    prior[static_cast<Eigen::Index>(6 + j)] = 1 / (quarter * quarter);
  }
  return prior;
}

/// Deviation of every joint (of the base's numbers where there is none) in every view.
std::vector<std::vector<double>> deviations(const Table& table, const std::vector<View>& views,
                                            const Conditions& conditions) {
  const VectorX prior = prior_information(table);
  const Eigen::Index first = prior.size() > 6 ? 6 : 0, n = prior.size();
  const double weight = 1 / (conditions.noise_px * conditions.noise_px);
  const std::vector<bool> all(table.markers.size(), true);
  std::vector<std::vector<double>> result(static_cast<std::size_t>(n - first));
  for (const View& view : views) {
    MatrixX I = weight * information(look(table, view, conditions.camera), all);
    I.diagonal() += prior;
    const MatrixX covariance = I.ldlt().solve(MatrixX::Identity(n, n));
    for (Eigen::Index i = first; i < n; ++i) {
      result[static_cast<std::size_t>(i - first)].push_back(std::sqrt(covariance(i, i)));
    }
  }
  return result;
}

double log_mean(const std::vector<std::vector<double>>& deviations) {
  double sum = 0, count = 0;
  for (const auto& joint : deviations) {
    for (const double deviation : joint) sum += std::log(deviation), ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

std::vector<Candidate> candidates(const Table& table) {
  const Layout layout = layout_of(table);
  std::vector<Candidate> result;
  for (const TableMarker& marker : table.markers) {
    if (is_mark(marker)) continue;
    Candidate candidate = on_link(table, marker.body, marker.t_body_m, marker.normal);
    candidate.name = marker.name;
    result.push_back(candidate);
  }
  for (int body = -1; body < static_cast<int>(table.joints.size()); ++body) {
    const Anchor anchor = anchor_of(table, layout, body);
    for (const Vec3& place : pattern(anchor, layout.extent_m)) {
      result.push_back(on_link(table, body, place, anchor.normal));
    }
  }
  std::erase_if(result, [&](const Candidate& c) { return !is_free(table, c, layout.diameter_m); });
  return result;
}

std::vector<Advice> advise(const Table& table, const std::vector<View>& views, const Conditions& conditions,
                           std::size_t count) {
  const double diameter_m = layout_of(table).diameter_m;
  const std::vector<View> some = some_of(views);
  const double without = log_mean(deviations(table, some, conditions));
  std::vector<Advice> all;
  for (const Candidate& candidate : candidates(table)) {
    Table more = table;
    more.markers.push_back(to_marker(candidate, diameter_m));
    const auto with = deviations(more, some, conditions);
    Advice advice{candidate, {}, std::exp(without - log_mean(with))};
    for (const auto& joint : with) advice.median_with.push_back(median(joint));
    all.push_back(advice);
  }
  std::stable_sort(all.begin(), all.end(), [](const Advice& a, const Advice& b) { return a.gain > b.gain; });
  std::vector<Advice> best;
  for (const Advice& advice : all) {
    const auto same_body = [&](const Advice& b) { return b.candidate.body == advice.candidate.body; };
    if (std::any_of(best.begin(), best.end(), same_body)) continue;
    best.push_back(advice);
    if (best.size() == count) break;
  }
  return best;
}

}  // namespace articam::report
