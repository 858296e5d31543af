#pragma once
/// @file  The rows of a compiled model: what the generator writes and the core reads.
///
/// An object is a tree of joints below a floating root link {obj}. Links joined by fixed joints are
/// merged, so a body is named by the moving joint above it; -1 is the root. Rows are ordered so that
/// a parent comes before its children. Everything is a plain number: tables are constexpr.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace articam::model {

/// Raised when the meaning or the order of a field changes; generated headers check it.
inline constexpr int kTableSchema = 2;

enum class JointKind : std::uint8_t { revolute, continuous, prismatic };
enum class MarkerKind : std::uint8_t {
  point,              ///< a point of interest without a mark; never searched in an image
  ring,               ///< dark annulus, light inside and around it
  dot_light_on_dark,  ///< light disc
  dot_dark_on_light,  ///< dark disc
};

/// One moving joint. T_parent_joint places {joint} at q = 0 in the frame of the parent body; the
/// child body's frame is {joint} moved by q along or about the axis. A joint that mimics another has no value of its
/// own: it stands at ratio times the leader's value plus offset, and its limits are the leader's business.
struct JointRow {
  std::string_view name;  ///< as written in the URDF
  JointKind kind{};
  int parent{};                  ///< row of the parent body's joint, -1 for the root
  std::array<double, 3> axis{};  ///< unit vector in {joint}
  std::array<double, 3> t_parent_joint_m{};
  std::array<double, 4> r_parent_joint_wxyz{};
  double q_min{}, q_max{};  ///< rad or m; -+kUnlimited where there is no limit
  int leader{-1};           ///< row of the joint that it mimics, one with a value of its own; -1: it mimics none
  double ratio{1};          ///< its rate over the leader's
  double offset{};          ///< rad or m, where the leader is at 0
};

/// One marker or point of interest on a body.
struct MarkerRow {
  std::string_view name;  ///< the URDF link that carries it
  MarkerKind kind{};
  int body{};                        ///< row of the joint that moves it, -1 for the root
  std::array<double, 3> t_body_m{};  ///< its centre in the body's frame
  std::array<double, 3> normal{};    ///< outward unit normal in the body's frame
  double outer_diameter_m{};         ///< of a dot: its diameter; 0 for a point
  double inner_diameter_m{};         ///< of a ring; 0 otherwise
};

/// A joint of the URDF that was held: by `--freeze`, or because it mimics a joint that does not move. Its value is
/// part of the poses in the rows; the row here is for the reader.
struct FrozenRow {
  std::string_view name;  ///< as written in the URDF
  double value{};         ///< rad or m
};

inline constexpr double kUnlimited = 1e9;  ///< a limit that is never reached; finite on purpose

/// What a generated header offers. kQ0 is the start from the markers file (t_m, r_wxyz, joints),
/// meaningful only if kHasQ0.
template <class M>
concept Model = requires {
  { M::kName } -> std::convertible_to<std::string_view>;
  { M::kJoints[0] } -> std::convertible_to<JointRow>;
  { M::kMarkers[0] } -> std::convertible_to<MarkerRow>;
  { M::kHasQ0 } -> std::convertible_to<bool>;
  { M::kQ0[0] } -> std::convertible_to<double>;
};

/// Moving bodies, one below each row of kJoints.
template <class M>
inline constexpr int kNumBodies = static_cast<int>(M::kJoints.size());
template <class M>
inline constexpr int kNumMarkers = static_cast<int>(M::kMarkers.size());
/// Joint values: rows that mimic no other.
template <class M>
inline constexpr int kNumJoints = static_cast<int>(std::count_if(M::kJoints.begin(), M::kJoints.end(),
                                                                 [](const JointRow& row) { return row.leader < 0; }));
/// Degrees of freedom nv: 6 of the base, then the joint values. (The paper's q has nq = 7 + n numbers.)
template <class M>
inline constexpr int kDof = 6 + kNumJoints<M>;

namespace detail {
constexpr bool is_unit(double norm2) { return norm2 > 1 - 1e-12 && norm2 < 1 + 1e-12; }
template <std::size_t N>
constexpr double norm2(const std::array<double, N>& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return sum;
}

template <class M>
constexpr auto rows_with_a_value() {
  std::array<JointRow, static_cast<std::size_t>(kNumJoints<M>)> rows{};
  std::copy_if(M::kJoints.begin(), M::kJoints.end(), rows.begin(), [](const JointRow& row) { return row.leader < 0; });
  return rows;
}

/// Of every row, the index of the joint value that moves it.
template <class M>
constexpr auto values_of_rows() {
  std::array<int, M::kJoints.size()> value{};
  int next = 0;
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = M::kJoints[i].leader < 0 ? next++ : -1;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (value[i] < 0) value[i] = value[static_cast<std::size_t>(M::kJoints[i].leader)];
  }
  return value;
}
}  // namespace detail

/// The rows of the joint values, in their order in q.
template <class M>
inline constexpr auto kValueRows = detail::rows_with_a_value<M>();

/// kValueOfRow<M>[row]: index in q of the joint value that moves the row.
template <class M>
inline constexpr auto kValueOfRow = detail::values_of_rows<M>();

/// Parents first, unit axes, quaternions and normals, ordered limits, leaders and bodies that exist.
template <class M>
constexpr bool is_well_formed() {
  int row = 0;
  for (const JointRow& joint : M::kJoints) {
    if (joint.parent < -1 || joint.parent >= row++) return false;
    if (!detail::is_unit(detail::norm2(joint.axis))) return false;
    if (!detail::is_unit(detail::norm2(joint.r_parent_joint_wxyz))) return false;
    if (!(joint.q_min <= joint.q_max)) return false;
    if (joint.leader < -1 || joint.leader >= kNumBodies<M> || joint.ratio == 0) return false;
    if (joint.leader >= 0 && M::kJoints[static_cast<std::size_t>(joint.leader)].leader != -1) return false;
  }
  for (const MarkerRow& marker : M::kMarkers) {
    if (marker.body < -1 || marker.body >= row) return false;
    if (!detail::is_unit(detail::norm2(marker.normal))) return false;
    if (marker.kind == MarkerKind::point ? marker.outer_diameter_m != 0 : !(marker.outer_diameter_m > 0)) return false;
    if (marker.kind == MarkerKind::ring &&
        !(marker.inner_diameter_m > 0 && marker.inner_diameter_m < marker.outer_diameter_m))
      return false;
  }
  return M::kQ0.size() == static_cast<std::size_t>(7 + kNumJoints<M>);
}

}  // namespace articam::model
