#pragma once
/// @file  Joint limits as what they are: inequalities of the least-squares step.

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/tracker/normal_equations.hpp"

namespace articam::tracker {

/// The Gauss-Newton step, its diagonal raised by the damping (Levenberg, Marquardt): (5) with lambda = 1 and the
/// pseudo-inverse weighted. Errors  ill_conditioned; `step` is then unchanged.
template <class M, class S>
[[gnu::noinline]] Status damped_step(const Normal<M, S>& normal, S damping, Vec<S, model::kDof<M>>& step) noexcept {
  math::TreeFactor<math::Chain<model::kDof<M>>, S> factor;
  if (const Status status = factor.factorise(normal.H, damping); status != Status::ok) return status;
  factor.solve(normal.b.data(), step.data());
  return Status::ok;
}

/// Which joints are held: 1 at q_max, -1 at q_min, 0 free.
template <class M>
using HeldJoints = std::array<std::int8_t, static_cast<std::size_t>(model::kNumJoints<M>)>;

namespace detail {

/// What a joint that is held has to step. It is at the limit then.
template <class M, class S>
S step_to_limit(int joint, std::int8_t side, const model::Configuration<M, S>& q) noexcept {
  const model::JointRow& row = model::kValueRows<M>[static_cast<std::size_t>(joint)];
  return static_cast<S>(side > 0 ? row.q_max : row.q_min) - q.joints[joint];
}

/// Holds the joint that the step takes farthest beyond a limit. False: none is.
template <class M, class S>
bool hold_worst(const model::Configuration<M, S>& q, const Vec<S, model::kDof<M>>& step, HeldJoints<M>& held) noexcept {
  S worst{0};
  std::size_t joint = 0;
  std::int8_t side = 0;
  for (int j = 0; j < model::kNumJoints<M>; ++j) {
    if (held[static_cast<std::size_t>(j)] != 0) continue;
    const S above = step[6 + j] - step_to_limit<M, S>(j, 1, q), below = step_to_limit<M, S>(j, -1, q) - step[6 + j];
    if (above > worst) worst = above, joint = static_cast<std::size_t>(j), side = 1;
    if (below > worst) worst = below, joint = static_cast<std::size_t>(j), side = -1;
  }
  if (side != 0) held[joint] = side;
  return side != 0;
}

/// Lets go the joint that the cost draws inwards most (its multiplier has the wrong sign). False: none is.
template <class M, class S>
bool release_worst(const Normal<M, S>& normal, S damping, const Vec<S, model::kDof<M>>& step,
                   HeldJoints<M>& held) noexcept {
  S worst{0};
  std::int8_t* joint = nullptr;
  for (std::size_t j = 0; j < held.size(); ++j) {
    const int k = 6 + static_cast<int>(j);
    S outwards = normal.b[static_cast<std::size_t>(k)] - damping * normal.H(k, k) * step[k];
    for (int i = 0; i < model::kDof<M>; ++i) outwards -= normal.H(k, i) * step[i];
    outwards *= static_cast<S>(held[j]);
    if (outwards < worst) worst = outwards, joint = &held[j];
  }
  if (joint != nullptr) *joint = 0;
  return joint != nullptr;
}

/// The equations of the rest, the steps of those that are held being known.
template <class M, class S>
Normal<M, S> held_equations(Normal<M, S> normal, S damping, const model::Configuration<M, S>& q,
                            const HeldJoints<M>& held) noexcept {
  for (std::size_t j = 0; j < held.size(); ++j) {
    if (held[j] == 0) continue;
    const int k = 6 + static_cast<int>(j);
    const S known = step_to_limit<M, S>(static_cast<int>(j), held[j], q);
    for (int i = 0; i < model::kDof<M>; ++i) {
      if (i == k) continue;
      S& entry = normal.H.at(i > k ? i : k, i > k ? k : i);
      normal.b[static_cast<std::size_t>(i)] -= entry * known;
      entry = S(0);
    }
    normal.b[static_cast<std::size_t>(k)] = normal.H(k, k) * (S(1) + damping) * known;
  }
  return normal;
}

}  // namespace detail

/// The step that lowers the quadratic cost most among those that keep every joint within its limits: a primal active
/// set, one joint at a time. `held`: those that stay at a limit.
/// Work  one factorisation where nothing is held, at most 1 + 3 n.  Errors  ill_conditioned.
template <class M, class S>
Status limited_step(const Normal<M, S>& normal, S damping, const model::Configuration<M, S>& q,
                    Vec<S, model::kDof<M>>& step, HeldJoints<M>& held) noexcept {
  held = {};
  Status status = damped_step<M, S>(normal, damping, step);
  for (int pass = 0; status == Status::ok && pass < 3 * model::kNumJoints<M>; ++pass) {
    if (!detail::hold_worst<M, S>(q, step, held) && !detail::release_worst<M, S>(normal, damping, step, held)) break;
    status = damped_step<M, S>(detail::held_equations<M, S>(normal, damping, q, held), damping, step);
  }
  return status;
}

}  // namespace articam::tracker
