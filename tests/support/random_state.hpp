#pragma once
/// @file  Random configurations and steps, the same on every machine.

#include <cstdint>

#include "core/model/configuration.hpp"

namespace articam::test {

/// Uniform numbers from a seed: splitmix64, so that no library decides what they are.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_{seed} {}

  double uniform(double low, double high) {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return low + (high - low) * static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
  }
  /// Mean 0, deviation 1, as the sum of twelve: no tail beyond 6, enough for noise on features.
  double gaussian() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform(0, 1);
    return sum;
  }
  template <class S, int N>
  Vec<S, N> vector(double low, double high) {
    Vec<S, N> v;
    for (int i = 0; i < N; ++i) v[i] = static_cast<S>(uniform(low, high));
    return v;
  }
  /// In front of the camera, turned by up to 0.6 rad about any axis, joints within +-0.3.
  template <class M, class S>
  model::Configuration<M, S> configuration() {
    model::Configuration<M, S> q;
    q.T_cam_obj.t = Vec<S, 3>{static_cast<S>(uniform(-0.1, 0.1)), static_cast<S>(uniform(-0.1, 0.1)),
                              static_cast<S>(uniform(0.7, 1.2))};
    q.T_cam_obj.R = math::exp_so3<S>(vector<S, 3>(-0.35, 0.35));
    q.joints = vector<S, model::kNumJoints<M>>(-0.3, 0.3);
    return q;
  }

 private:
  std::uint64_t state_;
};

}  // namespace articam::test
