#include "hal/app/start.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

namespace articam::app {

std::optional<std::vector<double>> parse_numbers(const std::string& text) {
  std::istringstream words{text};
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    double x = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(x)) return std::nullopt;
    numbers.push_back(x);
  }
  return numbers;
}

std::string why_no_start(const std::vector<double>& numbers) {
  constexpr double kFarthest = 1e6;  // m or rad, as for the drawing of an object
  const auto far = [](double x) { return std::abs(x) > kFarthest; };
  if (std::any_of(numbers.begin(), numbers.end(), far)) return fmt::format("a number is beyond {:g}", kFarthest);
  if (!(numbers[2] > 0)) return "pz is not positive: the base is not in front of the camera";
  return {};
}

}  // namespace articam::app
