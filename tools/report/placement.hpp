#pragma once
/// @file  Where one more mark would help most.

#include <string>
#include <vector>

#include "tools/report/observability.hpp"

namespace articam::report {

/// One place for one more mark of the size of those that are there.
struct Candidate {
  std::string link;  ///< the frame in which the place is written; empty for a --poi, which `name` tells
  std::string name;
  Vec3 place{Vec3::Zero()};  ///< m
  Vec3 normal{Vec3::UnitZ()};
  int body{};
  Vec3 t_body_m{Vec3::Zero()}, normal_body{Vec3::UnitZ()};
};

struct Advice {
  Candidate candidate;
  /// Median deviation of every joint (of the base's numbers where the model has none) with it, over the views.
  std::vector<double> median_with;
  double gain{};  ///< geometric mean over joints and views of deviation without over deviation with
};

/// Places on every body: those of the user's --poi points, and a pattern about the marks of the body, or about its
/// joint where it has none, as far out as the object's marks are apart. Nothing of the shape is known: whether a place
/// is on the object is for the user to see.
std::vector<Candidate> candidates(const modelgen::Table& table);

/// The best places, best first, at most `count`, one a body. A joint counts as known to a quarter of
/// its limits beforehand, so that a place which makes it observed wins. A place nearer than 1.5 diameters to a mark is
/// left out.
std::vector<Advice> advise(const modelgen::Table& table, const std::vector<View>& views, const Conditions& conditions,
                           std::size_t count);

}  // namespace articam::report
