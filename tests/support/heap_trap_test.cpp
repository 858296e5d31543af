#include "tests/support/heap_trap.hpp"

#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace articam::test {
namespace {

class HeapTrapTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!HeapTrap::works()) GTEST_SKIP() << "the heap is not ours here: a sanitizer has it, or this is not glibc";
  }
};

/// Tells the compiler that the block is used, or it would leave out the pair of calls.
void use(void* block) { asm volatile("" : : "r"(block) : "memory"); }

TEST_F(HeapTrapTest, CatchesMallocAndFree) {
  const HeapTrap trap;
  void* const block = std::malloc(10);
  use(block);
  EXPECT_EQ(trap.calls(), 1);
  std::free(block);
  EXPECT_EQ(trap.calls(), 2);
}

TEST_F(HeapTrapTest, CatchesOperatorNewAndDelete) {
  const HeapTrap trap;
  int* const number = new int{3};
  use(number);
  EXPECT_EQ(trap.calls(), 1);
  delete number;
  EXPECT_EQ(trap.calls(), 2);
}

TEST_F(HeapTrapTest, CatchesAlignedBlocksAndBlocksThatGrow) {
  struct alignas(64) Line {
    std::array<char, 64> bytes;
  };
  const HeapTrap trap;
  const auto line = std::make_unique<Line>();
  use(line.get());
  EXPECT_EQ(trap.calls(), 1);
  void* block = std::calloc(2, 8);
  use(block);
  block = std::realloc(block, 4000);
  use(block);
  EXPECT_EQ(trap.calls(), 3);
  std::free(block);
}

TEST_F(HeapTrapTest, CatchesAllocationsInsideTheStandardLibrary) {
  const HeapTrap trap;
  std::string text(1000, 'a');  // compiled into the shared library, not into this program
  use(text.data());
  EXPECT_EQ(trap.calls(), 1);
}

TEST_F(HeapTrapTest, CountsOnlySinceItWasSet) {
  std::vector<int> before(100);
  use(before.data());
  const HeapTrap trap;
  before[3] = 4;
  use(before.data());
  EXPECT_EQ(trap.calls(), 0);
}

}  // namespace
}  // namespace articam::test
