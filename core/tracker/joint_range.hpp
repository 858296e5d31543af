#pragma once
/// @file  Where a joint may stand.

#include "core/model/configuration.hpp"

namespace articam::tracker {

template <class S>
struct JointRange {
  S low, high;  ///< rad or m
  S middle() const noexcept { return S(0.5) * (low + high); }
  S length() const noexcept { return high - low; }
};

/// The limits of joint value j; of a joint that turns freely, or by several turns, one turn about its middle: marks do
/// not tell the others. A slide without limits is searched for 1 m either way.
template <class M, class S>
JointRange<S> joint_range(int j) noexcept {
  constexpr S kPi = S(3.14159265358979323846);
  const model::JointRow& row = model::kValueRows<M>[static_cast<std::size_t>(j)];
  const S half = row.kind == model::JointKind::prismatic ? S(1) : kPi;
  const bool open = row.q_min <= -model::kUnlimited || row.q_max >= model::kUnlimited;
  const bool many = row.kind != model::JointKind::prismatic && row.q_max - row.q_min > 2 * double(kPi);
  if (!open && !many) return {static_cast<S>(row.q_min), static_cast<S>(row.q_max)};
  const S middle = open ? S(0) : static_cast<S>(0.5 * (row.q_min + row.q_max));
  return {middle - half, middle + half};
}

/// Every joint amid its range.
template <class M, class S>
Vec<S, model::kNumJoints<M>> middle_joints() noexcept {
  Vec<S, model::kNumJoints<M>> joints;
  for (int j = 0; j < model::kNumJoints<M>; ++j) joints[j] = joint_range<M, S>(j).middle();
  return joints;
}

}  // namespace articam::tracker
