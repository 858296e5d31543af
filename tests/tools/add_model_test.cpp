// What articam_add_model in CMakeLists.txt made of data/kitchen_door.urdf.
#include "models/kitchen_door.hpp"

#include <gtest/gtest.h>

namespace articam::models {
namespace {

TEST(AddModel, CompilesAUrdfAtBuildTime) {
  static_assert(model::Model<KitchenDoor>);
  static_assert(KitchenDoor::kName == "kitchen_door");
  static_assert(KitchenDoor::kMarkers.size() == 2);
  EXPECT_EQ(KitchenDoor::kMarkers[0].name, "handle");
}

TEST(AddModel, PassesItsOptionsOn) {
  static_assert(KitchenDoor::kJoints.size() == 1);  // latch is frozen
  EXPECT_EQ(KitchenDoor::kJoints[0].name, "hinge");
  EXPECT_EQ(KitchenDoor::kMarkers[1].name, "corner");
  EXPECT_EQ(KitchenDoor::kMarkers[1].t_body_m[1], -0.5);
}

}  // namespace
}  // namespace articam::models
