#pragma once
/// @file  A compiled model -> its kinematics at random configurations, as numbers to compare.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "core/model/point_jacobian.hpp"
#include "core/model/table_hash.hpp"
#include "tests/support/random_state.hpp"

namespace articam::test {

inline constexpr int kConfigurations = 20;

/// One configuration: joint values in the order of q; of every point its place in {obj}, in double and in float; and
/// of every point and joint value, point by point, the velocity and the angular velocity per unit rate.
struct Evaluation {
  std::vector<double> joints;
  std::vector<std::array<double, 3>> centres;
  std::vector<std::array<float, 3>> centres_float;
  std::vector<std::array<double, 6>> twists;
};

struct Evaluated {
  std::vector<std::string> joints, points;
  std::vector<Evaluation> configurations;
};

/// Within the limits, and within half a turn or half a metre where there are none.
template <class M>
Vec<double, model::kNumJoints<M>> random_joints(Random& random) {
  Vec<double, model::kNumJoints<M>> joints;
  for (int j = 0; j < model::kNumJoints<M>; ++j) {
    const model::JointRow& row = model::kValueRows<M>[static_cast<std::size_t>(j)];
    const double most = row.kind == model::JointKind::prismatic ? 0.5 : std::numbers::pi;
    joints[j] = random.uniform(std::max(row.q_min, -most), std::min(row.q_max, most));
  }
  return joints;
}

template <class M>
Evaluation evaluate(const Vec<double, model::kNumJoints<M>>& joints) {
  Evaluation result;
  result.joints.assign(joints.begin(), joints.end());
  const auto k = model::forward_kinematics<M, double>(joints);
  const auto kf = model::forward_kinematics<M, float>(joints.template cast<float>());
  for (std::size_t m = 0; m < M::kMarkers.size(); ++m) {
    const Vec<double, 3>& p = k.markers[m].centre;
    const Vec<float, 3>& pf = kf.markers[m].centre;
    result.centres.push_back({p.x(), p.y(), p.z()});
    result.centres_float.push_back({pf.x(), pf.y(), pf.z()});
    const auto J = model::point_jacobian<M, double>(k, Pose<double>{}, M::kMarkers[m].body);
    for (int j = 0; j < model::kNumJoints<M>; ++j) {
      const Vec<double, 3> omega = J.template block<3, 1>(3, 6 + j);
      const Vec<double, 3> v = J.template block<3, 1>(0, 6 + j) + omega.cross(p);
      result.twists.push_back({v.x(), v.y(), v.z(), omega.x(), omega.y(), omega.z()});
    }
  }
  return result;
}

template <class M>
Evaluated evaluate(std::uint64_t seed) {
  Evaluated result;
  for (const model::JointRow& row : model::kValueRows<M>) result.joints.emplace_back(row.name);
  for (const model::MarkerRow& row : M::kMarkers) result.points.emplace_back(row.name);
  Random random{seed};
  for (int i = 0; i < kConfigurations; ++i) result.configurations.push_back(evaluate<M>(random_joints<M>(random)));
  return result;
}

/// Of every bit of every number.
inline std::uint64_t hash_of(const Evaluated& evaluated) {
  model::Fnv1a hash;
  for (const Evaluation& one : evaluated.configurations) {
    for (const double x : one.joints) hash.put(x);
    for (const auto& p : one.centres) hash.put(p);
    for (const auto& p : one.centres_float) {
      hash.put(std::array{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    }
    for (const auto& twist : one.twists) hash.put(twist);
  }
  return hash.value();
}

}  // namespace articam::test
