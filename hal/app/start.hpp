#pragma once
/// @file  Where a tracker begins, as a user writes it.

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/tracker/tracker.hpp"

namespace articam::app {

/// Numbers separated by white space, in any locale; nothing where the text holds anything else.
std::optional<std::vector<double>> parse_numbers(const std::string& text);

/// Why a tracker cannot start there, or nothing. At least the three numbers of the base's position.
std::string why_no_start(const std::vector<double>& numbers);

/// Sets the start of a tracker to `numbers`, px py pz qw qx qy qz and the joints; they come from `--q0`, as `text`, or
/// from a recording. Returns what is wrong with them, or nothing.
template <class Model, class S>
std::string set_start(tracker::Tracker<Model, S>& tracker, const std::optional<std::vector<double>>& numbers,
                      const std::string& text) {
  constexpr std::size_t kNumbers = static_cast<std::size_t>(7 + model::kNumJoints<Model>);
  if (!numbers || numbers->size() != kNumbers) {
    return fmt::format("--q0 '{}': expected {} numbers: px py pz qw qx qy qz and {} joint value(s)", text, kNumbers,
                       model::kNumJoints<Model>);
  }
  if (const auto problem = why_no_start(*numbers); !problem.empty()) return fmt::format("--q0 '{}': {}", text, problem);
  std::array<double, kNumbers> fixed{};
  std::copy(numbers->begin(), numbers->end(), fixed.begin());
  const auto q0 = model::from_numbers<Model, S>(fixed);
  if (!q0.ok()) return fmt::format("--q0 '{}': the quaternion qw qx qy qz is zero, or a number is not finite", text);
  tracker.set_start(q0.value());
  return {};
}

}  // namespace articam::app
