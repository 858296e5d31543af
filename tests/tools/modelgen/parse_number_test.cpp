#include "tools/modelgen/parse_number.hpp"

#include <gtest/gtest.h>

namespace articam::modelgen {
namespace {

TEST(ParseNumber, TakesWhatPeopleWrite) {
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("-.5"), -0.5);
  EXPECT_EQ(parse_number("+2"), 2.0);
  EXPECT_EQ(parse_number("1e-3"), 1e-3);
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* text : {"", " 1", "1 ", "1,5", "0x10", "nan", "inf", "-inf", "1e999", "-1.57.", "+-1", "+", "pi"}) {
    EXPECT_FALSE(parse_number(text)) << text;
  }
}

TEST(ParseNumbers, SplitsAtAnyWhiteSpaceAndRefusesTheWholeListForOneBadWord) {
  EXPECT_EQ(parse_numbers(" 1\t2\n 3 "), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(parse_numbers("  "), std::vector<double>{});
  EXPECT_FALSE(parse_numbers("1 2 x"));
}

}  // namespace
}  // namespace articam::modelgen
