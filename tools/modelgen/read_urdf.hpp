#pragma once
/// @file  URDF text -> the tree as written, each part with its line. Knows the syntax, not the sense.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/source_file.hpp"

namespace articam::modelgen {

enum class JointType { revolute, continuous, prismatic, fixed, planar, floating };

struct UrdfLink {
  std::string name;
  int line{};
};

/// Units m and rad. Absent parts hold the default that the URDF specification gives them.
struct UrdfJoint {
  std::string name;
  int line{};
  JointType type{JointType::fixed};
  std::string parent, child;
  int parent_line{}, child_line{};
  std::array<double, 3> origin_xyz{}, origin_rpy{};
  std::array<double, 3> axis{1, 0, 0};
  int axis_line{};
  bool has_limit{};  ///< at least one of lower and upper is written
  double lower{}, upper{};
  int limit_line{};
  bool mimics{};       ///< it stands at ratio times the leader's value plus offset
  std::string leader;  ///< as written; after resolve_mimics one that mimics none
  double ratio{1}, offset{};
  int mimic_line{};
  std::optional<double> held;  ///< where resolve_mimics found that it stands still
  std::string narrowed_by;     ///< the last joint that mimics it and whose limits resolve_mimics made its own

  bool moves() const { return type != JointType::fixed; }
};

struct UrdfModel {
  std::string file;
  std::string robot;
  int line{};
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  std::size_t num_links{}, num_joints{};  ///< as written: what follows may add some
};

inline constexpr std::size_t kMaxLinks = 256;
inline constexpr int kMaxXmlDepth = 32;
inline constexpr int kMaxAttributes = 64;
inline constexpr double kMinAxis = 1e-9;       ///< a shorter axis has no direction left after its own rounding
inline constexpr double kMaxCoordinate = 1e6;  ///< m or rad; beyond it no drawing of an object goes

/// Errors  not well-formed XML, a DTD, nesting deeper than kMaxXmlDepth, more than kMaxAttributes in a tag,
///         more than kMaxLinks links or joints: no model. Missing attributes, malformed numbers: a model in which what
///         is wrong is empty or default, so that the check can go on and tell the rest. Meshes are never opened.
std::optional<UrdfModel> read_urdf(const SourceFile& source, Diagnostics& diagnostics);

}  // namespace articam::modelgen
