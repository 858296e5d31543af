#include "hal/posix/realtime.hpp"

#include <malloc.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <cerrno>
#include <cstring>

namespace articam::hal {
namespace {

std::string because(const std::string& what, int error, const std::string& mend) {
  return what + ": " + std::strerror(error) + "; " + mend;
}

}  // namespace

std::string lock_memory() {
  // Memory given back to the system would fault when it is taken again.
  ::mallopt(M_TRIM_THRESHOLD, -1);
  ::mallopt(M_MMAP_MAX, 0);
  touch_stack();
  if (::mlockall(MCL_CURRENT | MCL_FUTURE) == 0) return {};
  return because("memory is not locked", errno, "raise LimitMEMLOCK (ulimit -l) or give CAP_IPC_LOCK");
}

std::string set_fifo_priority(int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (::sched_setscheduler(0, SCHED_FIFO, &parameters) == 0) return {};
  return because("no real-time priority", errno, "raise LimitRTPRIO (ulimit -r) or give CAP_SYS_NICE");
}

std::string bind_to_cpu(int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (cpu >= 0 && cpu < CPU_SETSIZE) CPU_SET(static_cast<std::size_t>(cpu), &set);
  if (::sched_setaffinity(0, sizeof set, &set) == 0) return {};
  return because("not bound to CPU " + std::to_string(cpu), errno, "choose one that exists (nproc)");
}

void touch_stack() noexcept {
  constexpr std::size_t kPage = 4096;
  volatile char pages[kTouchedStack_bytes];
  for (std::size_t i = 0; i < sizeof pages; i += kPage) pages[i] = 0;
}

MemoryUse memory_use() noexcept {
  rusage usage{};
  ::getrusage(RUSAGE_THREAD, &usage);
  const struct mallinfo2 heap = ::mallinfo2();
  return {usage.ru_minflt, usage.ru_majflt, static_cast<std::int64_t>(heap.uordblks)};
}

}  // namespace articam::hal
