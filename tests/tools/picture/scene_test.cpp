#include "tools/picture/scene.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace articam::picture {
namespace {

const std::string kMarkers = "markers: [{frame: ring, type: ring, outer_diameter_m: 0.1, inner_diameter_m: 0.04}]\n";
const std::string kStart = "q0: [0, 0, 2, 1, 0, 0, 0, 0.5]\n";

/// A drawer that opens towards the camera, its ring turned to the camera; a follower turns by twice its way.
std::string cupboard(const std::string& more = "") {
  return "<robot name='cupboard'>"
         "<material name='red'><color rgba='1 0 0 1'/></material>"
         "<link name='shelf'><visual><geometry><sphere radius='0.2'/></geometry><material name='red'/></visual></link>"
         "<link name='drawer'/><link name='ring'/>"
         "<link name='flap'><visual><origin xyz='0 1 0'/><geometry><box size='0.1 0.2 0.3'/></geometry></visual></link>"
         "<joint name='slide' type='prismatic'><parent link='shelf'/><child link='drawer'/><axis xyz='0 0 -1'/>"
         "<limit lower='0' upper='1'/></joint>"
         "<joint name='mount' type='fixed'><parent link='drawer'/><child link='ring'/>"
         "<origin rpy='3.141592653589793 0 0'/></joint>"
         "<joint name='turn' type='revolute'><parent link='drawer'/><child link='flap'/><axis xyz='0 0 1'/>"
         "<limit lower='0' upper='2'/><mimic joint='slide' multiplier='3.141592653589793'/></joint>" +
         more + "</robot>";
}

std::optional<Scene> scene(const std::string& urdf, const std::string& markers, std::string& problems) {
  modelgen::Diagnostics diagnostics;
  auto result = scene_of({"m.urdf", urdf}, {"m.yaml", markers}, diagnostics);
  problems = diagnostics.text();
  return result;
}

TEST(Scene, PlacesEveryShapeAtTheStartFollowersIncluded) {
  std::string problems;
  const auto cupboard_scene = scene(cupboard(), kMarkers + kStart, problems);
  ASSERT_TRUE(cupboard_scene) << problems;
  const auto& shapes = cupboard_scene->shapes;
  ASSERT_EQ(shapes.size(), 3u);
  EXPECT_EQ(shapes[0].form, Form::sphere);
  EXPECT_EQ(shapes[0].colour, (Colour{1, 0, 0}));
  EXPECT_LT((shapes[0].T_cam_shape.t - Vec3(0, 0, 2)).norm(), 1e-12);
  // The slide stands at 0.5, so the flap has turned by a quarter: its y lies along -x of the camera.
  EXPECT_LT((shapes[1].T_cam_shape.t - Vec3(-1, 0, 1.5)).norm(), 1e-12);
  EXPECT_EQ(shapes[1].size, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(shapes[2].marker, 0);
  EXPECT_LT((shapes[2].T_cam_shape.t - Vec3(0, 0, 1.5)).norm(), 1e-3);  // a card's thickness
  EXPECT_TRUE(hidden_markers(*cupboard_scene).empty());
}

TEST(Scene, NamesAMarkerThatSomethingStandsBefore) {
  const std::string post =
      "<link name='post'><visual><geometry><cylinder radius='0.01' length='1'/></geometry></visual></link>"
      "<joint name='post_mount' type='fixed'><parent link='shelf'/><child link='post'/>"
      "<origin xyz='0.03 0 -1' rpy='1.5707963267948966 0 0'/></joint>";
  std::string problems;
  const auto behind = scene(cupboard(post), kMarkers + kStart, problems);
  ASSERT_TRUE(behind) << problems;
  EXPECT_EQ(hidden_markers(*behind), std::vector<std::string>{"ring"});
}

TEST(Scene, RefusesFilesThatDoNotSayWhereTheCameraStandsOrHowLargeAShapeIs) {
  std::string problems;
  EXPECT_FALSE(scene(cupboard(), kMarkers, problems));
  EXPECT_NE(problems.find("m.yaml: q0: is missing"), std::string::npos) << problems;
  for (const char* solid :
       {"<box size='1 2'/>", "<box size='1 2 x'/>", "<sphere radius='0'/>", "<cylinder radius='1'/>"}) {
    const std::string urdf =
        "<link name='post'><visual><geometry>" + std::string(solid) + "</geometry></visual></link>";
    const std::string mount = "<joint name='m' type='fixed'><parent link='shelf'/><child link='post'/></joint>";
    EXPECT_FALSE(scene(cupboard(urdf + mount), kMarkers + kStart, problems)) << solid;
    EXPECT_NE(problems.find("m.urdf:1: <"), std::string::npos) << problems;
  }
}

TEST(Scene, NamesAMarkerThatIsNotWhollyInThePicture) {
  std::string problems;
  const auto cupboard_scene = scene(cupboard(), kMarkers + kStart, problems);
  ASSERT_TRUE(cupboard_scene) << problems;
  CameraParameters camera;  // the ring is 0.1 m across at 1.5 m, in the middle of the view
  camera.width_px = camera.height_px = 101;
  camera.fx_px = camera.fy_px = 750;
  camera.cx_px = camera.cy_px = 50;
  EXPECT_TRUE(cut_markers(*cupboard_scene, camera).empty());
  camera.cx_px = 20;
  EXPECT_EQ(cut_markers(*cupboard_scene, camera), std::vector<std::string>{"ring"});
  EXPECT_TRUE(hidden_markers(*cupboard_scene).empty());
}

TEST(Scene, LeavesAJointThatNothingTellsOfWhereItsLimitsAreNearestTo0) {
  const std::string lid =
      "<link name='lid'><visual><geometry><sphere radius='0.1'/></geometry></visual></link>"
      "<joint name='lift' type='prismatic'><parent link='shelf'/><child link='lid'/><axis xyz='0 1 0'/>"
      "<limit lower='0.3' upper='0.6'/></joint>";
  std::string problems;
  const auto lifted = scene(cupboard(lid), kMarkers + kStart, problems);
  ASSERT_TRUE(lifted) << problems;
  EXPECT_LT((lifted->shapes[2].T_cam_shape.t - Vec3(0, 0.3, 2)).norm(), 1e-12);
}

TEST(Scene, LeavesMeshesOutAndSaysSo) {
  const std::string mesh =
      "<link name='post'><visual><geometry><mesh filename='file:///dev/zero'/></geometry></visual></link>"
      "<joint name='m' type='fixed'><parent link='shelf'/><child link='post'/></joint>";
  std::string problems;
  const auto result = scene(cupboard(mesh), kMarkers + kStart, problems);
  ASSERT_TRUE(result) << problems;
  EXPECT_EQ(result->shapes.size(), 3u);
  EXPECT_NE(problems.find("m.urdf:1: <visual>: warning: 1 of them not drawn"), std::string::npos) << problems;
}

}  // namespace
}  // namespace articam::picture
