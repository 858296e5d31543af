#pragma once
/// @file  The newest value from one thread to another; neither ever waits for the other.

#include <array>
#include <atomic>
#include <cstdint>

namespace articam::receiver {

/// One writer, one reader. Of the three slots the writer has one, the reader has one, and the third changes hands by a
/// single atomic exchange: wait-free on both sides.
template <class T>
class TripleBuffer {
 public:
  /// The writer's slot; it holds some older value.
  T& back() noexcept { return slots_[back_]; }
  /// Gives the back slot to the reader.
  void publish() noexcept { back_ = middle_.exchange(back_ | kNew, std::memory_order_acq_rel) & kSlot; }

  /// The newest published value; the reader's own until its next call.
  const T& newest() noexcept {
    if ((middle_.load(std::memory_order_relaxed) & kNew) != 0) {
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kSlot;
    }
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t kSlot = 3, kNew = 4;

  std::array<T, 3> slots_{};
  std::atomic<std::uint8_t> middle_{1};
  std::uint8_t back_{0};   // of the writer
  std::uint8_t front_{2};  // of the reader
};

}  // namespace articam::receiver
