#pragma once
/// @file  Planar and floating joints -> elementary ones in a row, so that nothing behind knows of them.

#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/read_urdf.hpp"

namespace articam::modelgen {

/// A planar joint NAME becomes the joints NAME.x, NAME.y (prismatic, in the plane) and NAME.theta (continuous, about
/// the axis, which is the plane's normal); x and y are those of the joint's frame after the shortest turn that brings
/// its z to the normal. A floating joint becomes NAME.x, .y, .z (prismatic) and NAME.yaw, .pitch, .roll (continuous,
/// about z, y, x in this order, URDF's rpy); at a pitch of a quarter turn yaw and roll are one. All are unlimited.
/// Links without a marker, of the same names, stand between them.
/// Warnings  limits of such a joint are ignored.
/// Errors    mimic on such a joint.  A planar joint with a zero axis is left for the check to refuse.
void expand_joints(UrdfModel& model, Diagnostics& diagnostics);

}  // namespace articam::modelgen
