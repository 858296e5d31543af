#include "tests/corpus/kdl_oracle.hpp"

#include <tinyxml2.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <kdl/treefksolverpos_recursive.hpp>
#include <kdl/treejnttojacsolver.hpp>
#include <set>

namespace articam::test {
namespace {

void set_absent(tinyxml2::XMLElement& element, const char* attribute, const char* value) {
  if (element.Attribute(attribute) == nullptr) element.SetAttribute(attribute, value);
}

std::string relax(const std::string& urdf) {
  tinyxml2::XMLDocument document;
  document.Parse(urdf.c_str());
  auto& robot = *document.FirstChildElement("robot");
  set_absent(robot, "name", "unnamed");
  std::set<std::string> links;
  for (auto* link = robot.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
    links.insert(link->Attribute("name"));
  }
  for (auto* joint = robot.FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint")) {
    auto* limit = joint->FirstChildElement("limit");
    if (limit == nullptr) limit = joint->InsertNewChildElement("limit");
    set_absent(*limit, "effort", "0");
    set_absent(*limit, "velocity", "0");
    const std::string parent = joint->FirstChildElement("parent")->Attribute("link");
    if (links.insert(parent).second) robot.InsertNewChildElement("link")->SetAttribute("name", parent.c_str());
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

/// What moves about or along one axis of a joint; NAME and suffix name it.
struct Part {
  const char* suffix;
  KDL::Joint::JointType type;
  KDL::Vector axis{};  ///< in the joint's frame, unit
};

/// A planar or floating joint by the definition of tools/modelgen/expand_joints.hpp, any other as it is.
std::vector<Part> parts_of(const urdf::Joint& joint) {
  const KDL::Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  KDL::Vector axis(joint.axis.x, joint.axis.y, joint.axis.z);
  axis.Normalize();
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
      return {{"", KDL::Joint::RotAxis, axis}};
    case urdf::Joint::PRISMATIC:
      return {{"", KDL::Joint::TransAxis, axis}};
    case urdf::Joint::PLANAR: {
      const KDL::Vector about = z * axis;  // the shortest turn of z to the normal
      const KDL::Rotation turn = about.Norm() > 0 ? KDL::Rotation::Rot(about, std::atan2(about.Norm(), axis.z()))
                                                  : KDL::Rotation::RotX(std::acos(axis.z()));
      return {{".x", KDL::Joint::TransAxis, turn * x},
              {".y", KDL::Joint::TransAxis, turn * y},
              {".theta", KDL::Joint::RotAxis, axis}};
    }
    case urdf::Joint::FLOATING:
      return {{".x", KDL::Joint::TransAxis, x}, {".y", KDL::Joint::TransAxis, y},   {".z", KDL::Joint::TransAxis, z},
              {".yaw", KDL::Joint::RotAxis, z}, {".pitch", KDL::Joint::RotAxis, y}, {".roll", KDL::Joint::RotAxis, x}};
    default:
      return {{"", KDL::Joint::None}};
  }
}

/// The parts in a row; the first stands at the joint's origin, the last carries the child.
void add_joint(const urdf::Joint& joint, KDL::Tree& tree) {
  const urdf::Vector3& p = joint.parent_to_joint_origin_transform.position;
  const urdf::Rotation& r = joint.parent_to_joint_origin_transform.rotation;
  KDL::Frame origin(KDL::Rotation::Quaternion(r.x, r.y, r.z, r.w), KDL::Vector(p.x, p.y, p.z));
  std::string parent = joint.parent_link_name;
  const std::vector<Part> parts = parts_of(joint);
  for (const Part& part : parts) {
    const std::string name = joint.name + part.suffix, link = &part == &parts.back() ? joint.child_link_name : name;
    const KDL::Joint kdl = part.type == KDL::Joint::None ? KDL::Joint(name, KDL::Joint::None)
                                                         : KDL::Joint(name, origin.p, origin.M * part.axis, part.type);
    tree.addSegment(KDL::Segment(link, kdl, origin), parent);
    parent = link;
    origin = KDL::Frame::Identity();
  }
}

void add_children(const urdf::Link& link, KDL::Tree& tree) {
  for (const auto& child : link.child_links) {
    add_joint(*child->parent_joint, tree);
    add_children(*child, tree);
  }
}

}  // namespace

KdlOracle::KdlOracle(const std::string& urdf, bool relaxed) {
  const auto model = urdf::parseURDF(relaxed ? relax(urdf) : urdf);
  accepts_ = model != nullptr;
  if (!accepts_) return;
  tree_ = KDL::Tree(model->getRoot()->name);
  add_children(*model->getRoot(), tree_);
  q_.resize(std::max(1u, tree_.getNrOfJoints()));  // KDL reads the first of none
  for (const auto& [name, joint] : model->joints_) {
    for (const Part& part : parts_of(*joint)) ratios_[name + part.suffix] = {name + part.suffix};
    if (!joint->mimic) continue;
    Gear gear{name};
    for (auto at = joint; at && at->mimic; at = model->joints_[gear.leader]) {
      if (at->type == urdf::Joint::FIXED) break;
      gear.offset += gear.ratio * at->mimic->offset;
      gear.ratio *= at->mimic->multiplier;
      gear.leader = at->mimic->joint_name;
    }
    ratios_[name] = gear;
  }
}

void KdlOracle::set(const std::map<std::string, double>& values) {
  for (const auto& [link, segment] : tree_.getSegments()) {
    const KDL::Joint& joint = segment.segment.getJoint();
    if (joint.getType() == KDL::Joint::None) continue;
    const Gear& gear = ratios_.at(joint.getName());
    const auto leader = values.find(gear.leader);
    q_(segment.q_nr) = gear.ratio * (leader == values.end() ? 0 : leader->second) + gear.offset;
  }
}

std::array<double, 3> KdlOracle::place(const std::string& link) const {
  KDL::Frame frame;
  KDL::TreeFkSolverPos_recursive(tree_).JntToCart(q_, frame, link);
  return {frame.p.x(), frame.p.y(), frame.p.z()};
}

std::map<std::string, std::array<double, 6>> KdlOracle::twists(const std::string& link) const {
  KDL::Jacobian jacobian(tree_.getNrOfJoints());
  KDL::TreeJntToJacSolver(tree_).JntToJac(q_, jacobian, link);
  std::map<std::string, std::array<double, 6>> twists;
  for (const auto& [name, segment] : tree_.getSegments()) {
    const KDL::Joint& joint = segment.segment.getJoint();
    if (joint.getType() == KDL::Joint::None) continue;
    const Gear& gear = ratios_.at(joint.getName());
    const KDL::Twist column = jacobian.getColumn(segment.q_nr);
    for (int i = 0; i < 6; ++i) twists[gear.leader][static_cast<std::size_t>(i)] += gear.ratio * column(i);
  }
  return twists;
}

double KdlOracle::reach(const std::string& link) const {
  double length = 0;
  for (const KDL::TreeElement* at = &element(link); at->parent != tree_.getSegments().end(); at = &at->parent->second) {
    const KDL::Segment& segment = at->segment;
    const bool moves = segment.getJoint().getType() != KDL::Joint::None;
    length += segment.pose(moves ? q_(at->q_nr) : 0).p.Norm();
    if (at->parent->first == tree_.getRootSegment()->first) break;
  }
  return length;
}

}  // namespace articam::test
