#pragma once
/// @file  What urdfdom and KDL make of a URDF: the places of its leaves and how its joints move them.

#include <array>
#include <kdl/jntarray.hpp>
#include <kdl/tree.hpp>
#include <map>
#include <string>
#include <vector>

namespace articam::test {

class KdlOracle {
 public:
  /// `relaxed` mends first what urdfdom is strict about: no robot name, no limits, no effort or velocity in them, a
  /// parent link that is not declared.
  KdlOracle(const std::string& urdf, bool relaxed);

  bool accepts() const { return accepts_; }

  /// Values of the joints that mimic none; every other joint follows. KDL knows no planar and floating joints: they are
  /// their parts, as our compiler names them (NAME.x, ...).
  void set(const std::map<std::string, double>& values);
  std::array<double, 3> place(const std::string& link) const;
  /// Twist of the link's origin per unit rate of every joint that mimics none: velocity, then angular velocity.
  std::map<std::string, std::array<double, 6>> twists(const std::string& link) const;
  /// Length of the way from the root to the link along the origins between, m.
  double reach(const std::string& link) const;
  bool has_joint(const std::string& joint) const { return ratios_.count(joint) > 0; }

 private:
  /// How a joint follows the one at the end of its chain of mimics.
  struct Gear {
    std::string leader;
    double ratio{1}, offset{};
  };

  const KDL::TreeElement& element(const std::string& link) const { return tree_.getSegment(link)->second; }

  bool accepts_{false};
  KDL::Tree tree_;
  std::map<std::string, Gear> ratios_;
  KDL::JntArray q_;
};

}  // namespace articam::test
