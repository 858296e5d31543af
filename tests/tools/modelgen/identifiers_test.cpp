#include "tools/modelgen/identifiers.hpp"

#include <gtest/gtest.h>

namespace articam::modelgen {
namespace {

std::vector<std::string> identifiers(const std::vector<std::string>& names) { return to_identifiers(names, "Joint"); }

TEST(Identifiers, AreThePascalCaseOfTheName) {
  EXPECT_EQ(identifiers({"drawer_slide", "LeftArm", "left-arm.joint/2", "class", "EOF", "__x", "2nd"}),
            (std::vector<std::string>{"kDrawerSlide", "kLeftArm", "kLeftArmJoint2", "kClass", "kEOF", "kX", "k2nd"}));
}

TEST(Identifiers, TellNamesApartThatTheFieldTellsApart) {
  EXPECT_EQ(identifiers({"joint_1_1", "joint_11"}), (std::vector<std::string>{"kJoint1_1", "kJoint11"}));
  EXPECT_EQ(identifiers({"a-b", "a_b", "a.b"}), (std::vector<std::string>{"kAB", "kAB_1", "kAB_2"}));
  EXPECT_EQ(identifiers({"a_b", "aB_1", "a-b"}), (std::vector<std::string>{"kAB", "kAB1", "kAB_2"}));
}

TEST(Identifiers, NumberWhatHasNoLetters) {
  EXPECT_EQ(identifiers({"\xE9\x96\xA2", "+", "kJoint1"}),
            (std::vector<std::string>{"kJoint0", "kJoint1", "kKJoint1"}));
}

}  // namespace
}  // namespace articam::modelgen
