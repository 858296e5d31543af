#pragma once
/// @file  Proof that a piece of code does not touch the heap.

namespace articam::test {

/// Counts what this thread asks of the heap while the trap stands: malloc, calloc, realloc, free, the aligned
/// ones, and with them operator new and delete, also from within shared libraries.
///
///     HeapTrap trap;
///     loop.step();
///     EXPECT_EQ(trap.calls(), 0);
///
/// Linking the library articam::heap_trap replaces the C heap of the whole test program by one that counts
/// and then asks the C library. Needs glibc; stands aside for sanitizers, which bring a heap of their own.
class HeapTrap {
 public:
  HeapTrap() noexcept;

  /// Calls of this thread since the trap was set; always 0 where it does not work.
  long calls() const noexcept;

  /// False where the heap could not be replaced: skip the test then.
  static bool works() noexcept;

 private:
  long calls_before_;
};

}  // namespace articam::test
