#pragma once
/// @file  A second reading of URDF for the tests: 4x4 matrices, libm, one product per joint. No code in common.

#include <tinyxml2.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace articam::modelgen::test {

/// Homogeneous, row by row.
struct Matrix4 {
  double m[4][4];
  double* operator[](std::size_t row) { return m[row]; }
  const double* operator[](std::size_t row) const { return m[row]; }
};

inline Matrix4 identity4() { return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}; }

inline Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
  Matrix4 c{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}

inline Matrix4 inverse(const Matrix4& m) {
  Matrix4 inv = identity4();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) inv[i][j] = m[j][i];
    inv[i][3] = -(m[0][i] * m[0][3] + m[1][i] * m[1][3] + m[2][i] * m[2][3]);
  }
  return inv;
}

/// Rodrigues' formula, about a unit axis.
inline Matrix4 rotation(const std::array<double, 3>& a, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), v = 1 - c;
  return {{{c + a[0] * a[0] * v, a[0] * a[1] * v - a[2] * s, a[0] * a[2] * v + a[1] * s, 0},
           {a[1] * a[0] * v + a[2] * s, c + a[1] * a[1] * v, a[1] * a[2] * v - a[0] * s, 0},
           {a[2] * a[0] * v - a[1] * s, a[2] * a[1] * v + a[0] * s, c + a[2] * a[2] * v, 0},
           {0, 0, 0, 1}}};
}

inline Matrix4 translation(const std::array<double, 3>& t) {
  Matrix4 m = identity4();
  for (std::size_t i = 0; i < 3; ++i) m[i][3] = t[i];
  return m;
}

class UrdfOracle {
 public:
  explicit UrdfOracle(const std::string& text) {
    document_.Parse(text.c_str());
    const auto* robot = document_.FirstChildElement("robot");
    for (auto* joint = robot->FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint")) {
      above_[joint->FirstChildElement("child")->Attribute("link")] = joint;
      joints_[joint->Attribute("name")] = joint;
      has_child_[joint->FirstChildElement("parent")->Attribute("link")] = true;
    }
    for (auto* link = robot->FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
      if (!has_child_[link->Attribute("name")]) leaves.push_back(link->Attribute("name"));
    }
  }

  /// Pose of a link in the root of the URDF; joints that are not named stand at 0.
  Matrix4 pose(const std::string& link, const std::map<std::string, double>& values) const {
    const auto found = above_.find(link);
    if (found == above_.end()) return identity4();
    const tinyxml2::XMLElement& joint = *found->second;
    const auto* origin = joint.FirstChildElement("origin");
    const auto xyz = numbers(origin, "xyz", {0, 0, 0}), rpy = numbers(origin, "rpy", {0, 0, 0});
    const Matrix4 fixed =
        translation(xyz) * rotation({0, 0, 1}, rpy[2]) * rotation({0, 1, 0}, rpy[1]) * rotation({1, 0, 0}, rpy[0]);
    return pose(joint.FirstChildElement("parent")->Attribute("link"), values) * fixed * motion(joint, values);
  }

  std::vector<std::string> leaves;

 private:
  static std::array<double, 3> numbers(const tinyxml2::XMLElement* element, const char* name,
                                       std::array<double, 3> value) {
    if (element == nullptr || element->Attribute(name) == nullptr) return value;
    std::istringstream stream(element->Attribute(name));
    stream >> value[0] >> value[1] >> value[2];
    return value;
  }

  static double value(const std::string& name, const std::map<std::string, double>& values) {
    const auto found = values.find(name);
    return found == values.end() ? 0 : found->second;
  }

  static double attribute(const tinyxml2::XMLElement& element, const char* name, double absent) {
    const char* const text = element.Attribute(name);
    if (text == nullptr) return absent;
    std::istringstream(text) >> absent;
    return absent;
  }

  /// Where a joint stands: at its own value, or where the joint that it mimics says, link by link of the chain.
  double position(const tinyxml2::XMLElement& joint, const std::map<std::string, double>& values) const {
    if (std::string(joint.Attribute("type")) == "fixed") return 0;
    const auto* mimic = joint.FirstChildElement("mimic");
    if (mimic == nullptr) return value(joint.Attribute("name"), values);
    return attribute(*mimic, "multiplier", 1) * position(*joints_.at(mimic->Attribute("joint")), values) +
           attribute(*mimic, "offset", 0);
  }

  /// x, y, z, then yaw, pitch, roll; of a planar joint, in its plane, x, y and theta.
  static Matrix4 free_motion(const std::string& name, bool planar, const std::array<double, 3>& normal,
                             const std::map<std::string, double>& values) {
    const auto of = [&](const char* part) { return value(name + part, values); };
    const Matrix4 moved = translation({of(".x"), of(".y"), of(".z")});
    if (!planar) {
      return moved * rotation({0, 0, 1}, of(".yaw")) * rotation({0, 1, 0}, of(".pitch")) *
             rotation({1, 0, 0}, of(".roll"));
    }
    const double length = std::hypot(normal[0], normal[1]);  // the turn that brings z to the normal is about z x normal
    const std::array<double, 3> about =
        length > 0 ? std::array{-normal[1] / length, normal[0] / length, 0.0} : std::array{1.0, 0.0, 0.0};
    const Matrix4 turn = rotation(about, std::atan2(length, normal[2]));
    return turn * moved * inverse(turn) * rotation(normal, of(".theta"));
  }

  Matrix4 motion(const tinyxml2::XMLElement& joint, const std::map<std::string, double>& values) const {
    auto axis = numbers(joint.FirstChildElement("axis"), "xyz", {1, 0, 0});
    const double norm = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    for (double& x : axis) x /= norm;
    const std::string type = joint.Attribute("type");
    if (type == "fixed") return identity4();
    if (type == "planar" || type == "floating")
      return free_motion(joint.Attribute("name"), type == "planar", axis, values);
    const double q = position(joint, values);
    if (type == "prismatic") return translation({axis[0] * q, axis[1] * q, axis[2] * q});
    return rotation(axis, q);
  }

  tinyxml2::XMLDocument document_;
  std::map<std::string, const tinyxml2::XMLElement*> above_;
  std::map<std::string, const tinyxml2::XMLElement*> joints_;
  std::map<std::string, bool> has_child_;
};

}  // namespace articam::modelgen::test
