#pragma once
/// @file  Text -> finite numbers, the same in every locale.

#include <optional>
#include <string_view>
#include <vector>

namespace articam::modelgen {

/// The whole text must be one finite decimal number; nothing otherwise.
std::optional<double> parse_number(std::string_view text);

/// Numbers between white space, as in a URDF attribute; nothing when one of them is not a number.
std::optional<std::vector<double>> parse_numbers(std::string_view text);

}  // namespace articam::modelgen
