#pragma once
/// @file  From where an object is looked at: the stated range of views, sampled.

#include <numbers>
#include <string>
#include <vector>

#include "core/camera_parameters.hpp"
#include "tools/report/marks.hpp"

namespace articam::report {

/// Told what is being done and how much of it, for people who wait.
using Says = void (*)(const char* what, double share);
inline void silent(const char*, double) {}

inline constexpr double kDegree = std::numbers::pi / 180;

/// What the report assumes of the camera and of where it stands.
struct Conditions {
  CameraParameters camera;  ///< its distortion is left out: a pinhole bounds as well
  double min_range_m{0.5}, max_range_m{1.5};
  double max_tilt_deg{60};  ///< between the view and the front, which is the mean of the marks' normals
  double noise_px{0.1};     ///< standard deviation of a mark's centre, each coordinate
};

/// 640x480, focal length 525 px.
CameraParameters default_camera();

struct View {
  Pose<double> T_cam_obj;
  VectorX joints;
  double range_m{}, tilt_deg{};  ///< of the camera from the marks' middle, and against their front
  Vec3 from{Vec3::Zero()};       ///< unit vector from the marks' middle to the camera, {obj}
};

/// Three ranges; tilts in steps of 20 deg with eight directions each; joints at 10, 50 and 90 % of their limits, all
/// alike, then mixtures of 10 and 90 % of which one parts any two joints. The camera looks at the middle of the marks.
/// A joint without limits is taken as half a turn or half a metre either way. Always the same, in the same order.
std::vector<View> sample_views(const modelgen::Table& table, const Conditions& conditions);

/// Limits as the sampling takes them.
double low_limit(const modelgen::TableJoint& joint);
double high_limit(const modelgen::TableJoint& joint);

/// Joint values at these shares of the way from the low limits to the high ones; one share for all joints.
VectorX joints_at(const modelgen::Table& table, const VectorX& shares);
VectorX joints_at(const modelgen::Table& table, double share);

/// Means over the marks, {obj}; of normals that face every way there is none, and -z stands for it.
struct Front {
  Vec3 middle{Vec3::Zero()};
  Vec3 normal{-Vec3::UnitZ()};
};
Front front_of(const modelgen::Table& table, const Marks& marks);

/// For people: `range 0.70 m, tilt 20 deg from (0.34 0.00 -0.94), drawer_slide 0.035`; of many joints, the one asked
/// for and a few.
std::string describe(const View& view, const modelgen::Table& table, std::size_t first_joint = 0);

/// Joint values in the order of the table: `a 0.1, b 0.2 and 3 more`.
std::string describe_joints(const VectorX& joints, const modelgen::Table& table, std::size_t first_joint = 0);

}  // namespace articam::report
