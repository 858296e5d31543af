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

/// One degree of freedom without one mark, among the views that see the mark.
struct Blinded {
  std::string name;
  bool is_of_base{};
  std::size_t num_with{}, num_without{};  ///< views that observe it with the mark, and still without
};

/// What one mark is good for.
struct Loss {
  std::string marker;
  double share_seen{}, share_outside_picture{}, share_turned_away{}, share_too_small{};  ///< of the views
  std::vector<Blinded> blinded;       ///< what fewer views observe without it
  std::vector<std::string> at_start;  ///< what is observed at q0 with it only
  std::string worst_grown;            ///< the joint (or, without joints, the number of the base) that suffers most
  double growth{1};                   ///< median factor on its deviation, over the views that observe it either way
  double least_singular_px{};         ///< median over the views that see it, without it
};

struct Observability {
  std::vector<Freedom> freedoms;  ///< tx ty tz rx ry rz of the base in {cam}, then the joint values
  std::vector<Loss> losses;       ///< one a mark
  double share_complete{};        ///< of the views: every degree of freedom observed
  double median_singular_px{};    ///< of the least singular values of all views
  double least_singular_px{};     ///< the least over the complete views; 0 where none is complete
  std::size_t least_singular_view{};
};

/// Names of the degrees of freedom, in the order of a Bound.
std::vector<std::string> freedom_names(const modelgen::Table& table);

/// `start` is the view at q0, or null.
Observability observe(const modelgen::Table& table, const std::vector<View>& views, const View* start,
                      const Conditions& conditions, Says says = silent);

/// Of numbers that may be none: NaN then.
double median(std::vector<double> numbers);

}  // namespace articam::report
