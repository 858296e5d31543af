#pragma once
/// @file  What a real-time thread asks of Linux: memory that stays, a priority, a processor.

#include <cstddef>
#include <cstdint>
#include <string>

namespace articam::hal {

/// All three act on the whole process or the calling thread and return an empty text, or a sentence that says what is
/// not to be had and how it would be.
std::string lock_memory();                    ///< present and future pages; the present stack is touched in advance
std::string set_fifo_priority(int priority);  ///< 1 to 99, SCHED_FIFO, of the calling thread
std::string bind_to_cpu(int cpu);             ///< of the calling thread

/// Touches kTouchedStack_bytes of the calling thread's stack, so that no later call faults.
void touch_stack() noexcept;
inline constexpr std::size_t kTouchedStack_bytes = 512 * 1024;

/// Faults of the calling thread and bytes that the process has of its heap, to show that both stand still.
struct MemoryUse {
  std::int64_t minor_faults{}, major_faults{};
  std::int64_t heap_bytes{};
};
MemoryUse memory_use() noexcept;

}  // namespace articam::hal
