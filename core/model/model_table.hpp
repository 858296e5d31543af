#pragma once
/// @file  The rows of a compiled model: what the generator writes and the core reads.
///
/// An object is a tree of joints below a floating root link {obj}. Links joined by fixed joints are
/// merged, so a body is named by the moving joint above it; -1 is the root. Rows are ordered so that
/// a parent comes before its children. Everything is a plain number: tables are constexpr.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace articam::model {

/// Raised when the meaning or the order of a field changes; generated headers check it.
inline constexpr int kTableSchema = 1;

enum class JointKind : std::uint8_t { revolute, continuous, prismatic };
enum class MarkerKind : std::uint8_t {
  point,              ///< a point of interest without a mark; never searched in an image
  ring,               ///< dark annulus, light inside and around it
  dot_light_on_dark,  ///< light disc
  dot_dark_on_light,  ///< dark disc
};

/// One moving joint. T_parent_joint places {joint} at q = 0 in the frame of the parent body; the
/// child body's frame is {joint} moved by q along or about the axis.
struct JointRow {
  std::string_view name;  ///< as written in the URDF
  JointKind kind{};
  int parent{};                  ///< row of the parent body's joint, -1 for the root
  std::array<double, 3> axis{};  ///< unit vector in {joint}
  std::array<double, 3> t_parent_joint_m{};
  std::array<double, 4> r_parent_joint_wxyz{};
  double q_min{}, q_max{};  ///< rad or m; -+kUnlimited where there is no limit
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

template <class M>
inline constexpr int kNumJoints = static_cast<int>(M::kJoints.size());
template <class M>
inline constexpr int kNumMarkers = static_cast<int>(M::kMarkers.size());
/// Degrees of freedom nv: 6 of the base, then the joints. (The paper's q has nq = 7 + n numbers.)
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
}  // namespace detail

/// Parents first, unit axes, quaternions and normals, ordered limits, bodies that exist.
template <class M>
constexpr bool is_well_formed() {
  int row = 0;
  for (const JointRow& joint : M::kJoints) {
    if (joint.parent < -1 || joint.parent >= row++) return false;
    if (!detail::is_unit(detail::norm2(joint.axis))) return false;
    if (!detail::is_unit(detail::norm2(joint.r_parent_joint_wxyz))) return false;
    if (!(joint.q_min <= joint.q_max)) return false;
  }
  for (const MarkerRow& marker : M::kMarkers) {
    if (marker.body < -1 || marker.body >= row) return false;
    if (!detail::is_unit(detail::norm2(marker.normal))) return false;
    if (marker.kind == MarkerKind::point ? marker.outer_diameter_m != 0 : !(marker.outer_diameter_m > 0)) return false;
    if (marker.kind == MarkerKind::ring &&
        !(marker.inner_diameter_m > 0 && marker.inner_diameter_m < marker.outer_diameter_m))
      return false;
  }
  return M::kQ0.size() == M::kJoints.size() + 7;
}

}  // namespace articam::model
