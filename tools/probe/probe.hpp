#pragma once
/// @file  Lines of joint values in, places and twists of every marker out.

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "core/math/types.hpp"
#include "core/model/forward_kinematics.hpp"
#include "core/model/point_jacobian.hpp"

namespace articam::probe {

/// The joint values of one line, finite numbers between blanks; nothing when there are not exactly that many.
template <class Model>
std::optional<Vec<double, model::kNumJoints<Model>>> parse_joints(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  Vec<double, model::kNumJoints<Model>> joints;
  Eigen::Index count = 0;
  for (auto begin = line.find_first_not_of(kBlanks); begin != line.npos; begin = line.find_first_not_of(kBlanks)) {
    line.remove_prefix(begin);
    double value = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc{} || !math::is_finite(value) || count == joints.size()) return std::nullopt;
    joints[count++] = value;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    if (!line.empty() && kBlanks.find(line[0]) == kBlanks.npos) return std::nullopt;
  }
  if (count != joints.size()) return std::nullopt;
  return joints;
}

/// A name as one word of a line, its blanks as `_`.
inline std::string word(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), ' ', '_');
  return text;
}

inline void print(const Vec<double, 3>& v, std::FILE* out) {
  std::fprintf(out, " %.17g %.17g %.17g", v[0], v[1], v[2]);
}

/// `marker` and `jac` lines, then `end`. Twists are those of the marker's centre, in {obj}.
template <class Model>
void print_block(const model::Kinematics<Model, double>& kinematics, std::FILE* out) {
  for (std::size_t m = 0; m < Model::kMarkers.size(); ++m) {
    const auto& row = Model::kMarkers[m];
    const std::string name = word(row.name);
    std::fprintf(out, "marker %s", name.c_str());
    print(kinematics.markers[m].centre, out);
    print(kinematics.markers[m].normal, out);
    std::fputc('\n', out);
    // In {obj} itself: the base's own columns are not asked for.
    const auto J = model::point_jacobian<Model, double>(kinematics, Pose<double>{}, row.body);
    for (int j = 0; j < model::kNumJoints<Model>; ++j) {
      const auto& joint = model::kValueRows<Model>[static_cast<std::size_t>(j)];
      const model::Twist<double> twist{J.template block<3, 1>(0, 6 + j), J.template block<3, 1>(3, 6 + j)};
      std::fprintf(out, "jac %s %s", name.c_str(), word(joint.name).c_str());
      print(twist.velocity_of(kinematics.markers[m].centre), out);
      print(twist.angular, out);
      std::fputc('\n', out);
    }
  }
  std::fputs("end\n", out);
  std::fflush(out);  // a program at the other end of a pipe waits for the block
}

/// Returns the exit code: 0, or 1 at the first line that is not a set of joint values or when `out` fails.
template <class Model>
int run(std::istream& in, std::FILE* out, std::FILE* err) {
  std::fputs("joints", out);
  for (const auto& joint : model::kValueRows<Model>) std::fprintf(out, " %s", word(joint.name).c_str());
  std::fputc('\n', out);
  std::fflush(out);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const auto joints = parse_joints<Model>(line);
    if (!joints) {
      std::fprintf(err, "stdin:%d: joints: expected %d finite numbers\n", number, model::kNumJoints<Model>);
      return 1;
    }
    print_block<Model>(model::forward_kinematics<Model, double>(*joints), out);
  }
  return std::ferror(out) != 0 ? 1 : 0;
}

}  // namespace articam::probe
