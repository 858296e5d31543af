#pragma once
/// @file  Where one more mark would help most.

#include <string>
#include <vector>

#include "tools/report/observability.hpp"

namespace articam::report {

/// One place for one more mark.
struct Candidate {
  std::string link;          ///< the frame in which the place is written
  std::string point;         ///< the --poi that it is; empty for a place of the pattern
  Vec3 place{Vec3::Zero()};  ///< m, as the link's frame has it
  Vec3 normal{Vec3::UnitZ()};
  modelgen::TableMarker mark;  ///< kind and size of most of the model's marks
};

/// What one more mark does to one joint (or, without joints, to a number of the base).
struct Effect {
  std::string name;
  bool is_metres{};
  double share_without{}, share_with{};    ///< of the views that observe it
  double median_without{}, median_with{};  ///< deviation over the views that observe it either way; NaN without any
};

struct Advice {
  Candidate candidate;
  std::vector<Effect> effects;
  double gain{1};  ///< geometric mean over joints and views of deviation without over deviation with, see advise()
};

/// Places on every body: those of the user's --poi points, and a pattern about the marks of the body, or about its
/// joint where it has none, up to as far out as these marks are apart, or the object's marks where the body has none or
/// one. Nothing of the shape is known: whether a place is on the object is for the user to see. A place nearer than 1.5
/// diameters to a mark at the middle of the joints' ranges is left out.
std::vector<Candidate> candidates(const modelgen::Table& table);

/// The best places, best first, at most `count`, one a body. Compared are deviations that know each joint within its
/// limits beforehand, so that a place which makes a joint observed wins; over every seventh view, which go through all
/// directions. The effects are of bounds without such knowledge, over all views.
std::vector<Advice> advise(const modelgen::Table& table, const std::vector<View>& views, const Conditions& conditions,
                           std::size_t count, Says says = silent);

}  // namespace articam::report
