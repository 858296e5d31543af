#pragma once
/// @file  Layouts that look the same with their marks exchanged: what identities would have to tell.

#include <vector>

#include "tools/report/view.hpp"

namespace articam::report {

/// A second configuration that puts marks of the same kind and size where the first has them.
struct Symmetry {
  /// Mark m of the first configuration lies on mark takes_place_of[m] of the second; all on themselves where not even
  /// identities would tell, as after a whole turn.
  std::vector<std::size_t> takes_place_of;
  VectorX joints, other_joints;
  Vec3 turn_rad{Vec3::Zero()};  ///< of the base between the two, rotation vector in {obj}
  double residual_m{};          ///< largest distance of two marks that should coincide

  bool needs_identities() const;  ///< whether some mark lies on another one
};

inline constexpr std::size_t kMaxSymmetries = 8;  ///< at each of the two settings of the joints

/// Searches, at joints amid their limits and at their lower ones, for a rigid motion with other joint values, within
/// their limits, under which the marks coincide within kCoincidence of the layout's extent, normals within 30 deg. From
/// every pair of marks onto every other pair and a few joint values, by alternating assignment and Gauss-Newton steps:
/// what it finds is true; that it finds everything is likely, not sure. A joint that the marks do not tell of is not a
/// symmetry.
std::vector<Symmetry> find_symmetries(const modelgen::Table& table, Says says = silent);

inline constexpr double kCoincidence = 0.01;

}  // namespace articam::report
