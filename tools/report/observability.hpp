#pragma once
/// @file  Over a range of views: which degrees of freedom are observed, how well, and what each mark is good for.

#include <cstddef>
#include <string>
#include <vector>

#include "tools/report/information.hpp"

namespace articam::report {

/// Above this dilution a joint is called weak: five times less is known than the same marks could tell.
inline constexpr double kWeakDilution = 5;

/// Of one degree of freedom over all views. Deviations in m or rad.
struct Freedom {
  std::string name;
  bool is_metres{};
  double share_observed{};   ///< of the views
  double share_weak{};       ///< of the views; observed, but weak
  double median{}, worst{};  ///< deviation where it is observed; NaN where it never is
  std::size_t worst_view{};  ///< the one with the largest dilution among those that observe it
  double worst_dilution{};
};

/// What happens without one mark, in the views that see it.
struct Loss {
  std::string marker;
  std::size_t num_views{};           ///< that see it
  std::vector<std::string> blinded;  ///< degrees of freedom that more than half of these views observe only with it
  std::string worst_grown;  ///< of the others, the joint (or, without joints, the base's number) that suffers most
  double growth{1};         ///< median factor on its deviation
};

struct Observability {
  std::vector<Freedom> freedoms;  ///< tx ty tz rx ry rz of the base in {cam}, then the joint values
  std::vector<Loss> losses;       ///< one a mark
  double least_singular_px{};     ///< over the views that observe everything; 0 where none does
  std::size_t least_singular_view{};
  double share_complete{};  ///< of the views: every degree of freedom observed
};

/// Names of the degrees of freedom, in the order of a Bound.
std::vector<std::string> freedom_names(const modelgen::Table& table);

Observability observe(const modelgen::Table& table, const std::vector<View>& views, const Conditions& conditions);

/// Of numbers that may be none: NaN then.
double median(std::vector<double> numbers);

}  // namespace articam::report
