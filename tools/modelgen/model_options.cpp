#include "tools/modelgen/model_options.hpp"

#include <algorithm>
#include <cmath>

#include "tools/modelgen/parse_number.hpp"
#include "tools/modelgen/read_urdf.hpp"

namespace articam::modelgen {

std::optional<Freeze> parse_freeze(const std::string& text) {
  const auto sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0) return std::nullopt;
  const auto value = parse_number(std::string_view(text).substr(sign + 1));
  if (!value || std::abs(*value) > kMaxCoordinate) return std::nullopt;
  return Freeze{text.substr(0, sign), *value};
}

std::optional<Marker> parse_point(const std::string& text) {
  const auto sign = text.find('='), colon = text.rfind(':');  // a link's name may hold colons
  if (sign == std::string::npos || colon == std::string::npos || sign == 0 || colon <= sign + 1) return std::nullopt;
  std::string list = text.substr(colon + 1);
  if (std::count(list.begin(), list.end(), ',') != 2 || list.find(' ') != std::string::npos) return std::nullopt;
  std::replace(list.begin(), list.end(), ',', ' ');
  const auto numbers = parse_numbers(list);
  if (!numbers || numbers->size() != 3) return std::nullopt;
  Marker point;
  point.name = text.substr(0, sign);
  point.frame = text.substr(sign + 1, colon - sign - 1);
  std::copy(numbers->begin(), numbers->end(), point.offset_m.begin());
  const auto far = [](double x) { return std::abs(x) > kMaxCoordinate; };
  if (std::any_of(numbers->begin(), numbers->end(), far)) return std::nullopt;
  return point;
}

}  // namespace articam::modelgen
