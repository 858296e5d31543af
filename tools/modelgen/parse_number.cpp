#include "tools/modelgen/parse_number.hpp"

#include <charconv>
#include <cmath>

namespace articam::modelgen {

std::optional<double> parse_number(std::string_view text) {
  // from_chars takes no plus sign, people write it; but not "+-1".
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  std::vector<double> numbers;
  for (auto begin = text.find_first_not_of(kSpace); begin != std::string_view::npos;) {
    const auto end = text.find_first_of(kSpace, begin);
    const auto number = parse_number(text.substr(begin, end - begin));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    begin = text.find_first_not_of(kSpace, end);
  }
  return numbers;
}

}  // namespace articam::modelgen
