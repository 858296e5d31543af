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

/// A joint as KDL has it: on its parent link's frame, its axis unit.
KDL::Joint to_kdl(const urdf::Joint& joint, const KDL::Frame& origin) {
  const KDL::Vector axis = origin.M * KDL::Vector(joint.axis.x, joint.axis.y, joint.axis.z);
  if (joint.type == urdf::Joint::PRISMATIC) return KDL::Joint(joint.name, origin.p, axis, KDL::Joint::TransAxis);
  const bool turns = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
  if (turns) return KDL::Joint(joint.name, origin.p, axis, KDL::Joint::RotAxis);
  return KDL::Joint(joint.name, KDL::Joint::None);
}

void add_children(const urdf::Link& link, KDL::Tree& tree) {
  for (const auto& child : link.child_links) {
    const urdf::Joint& joint = *child->parent_joint;
    const urdf::Pose& pose = joint.parent_to_joint_origin_transform;
    const urdf::Rotation& r = pose.rotation;
    const KDL::Frame origin(KDL::Rotation::Quaternion(r.x, r.y, r.z, r.w),
                            KDL::Vector(pose.position.x, pose.position.y, pose.position.z));
    tree.addSegment(KDL::Segment(child->name, to_kdl(joint, origin), origin), link.name);
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
