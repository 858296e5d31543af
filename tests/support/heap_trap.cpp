#include "tests/support/heap_trap.hpp"

#include <cerrno>
#include <cstddef>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define ARTICAM_OWN_HEAP 0
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define ARTICAM_OWN_HEAP 0
#endif
#ifndef ARTICAM_OWN_HEAP
#define ARTICAM_OWN_HEAP 1
#endif

namespace {
// initial-exec: the first access must not itself ask the heap for this thread's storage.
[[gnu::tls_model("initial-exec")]] thread_local long calls_of_this_thread = 0;
}  // namespace

#if ARTICAM_OWN_HEAP
// glibc's own heap under its second name, meant for replacements such as this one.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) {
  ++calls_of_this_thread;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++calls_of_this_thread;
  return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) {
  ++calls_of_this_thread;
  return __libc_realloc(block, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  ++calls_of_this_thread;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  void* const memory = memalign(alignment, size);
  if (memory == nullptr) return ENOMEM;
  *block = memory;
  return 0;
}
void free(void* block) {
  ++calls_of_this_thread;
  __libc_free(block);
}
}
#endif

namespace articam::test {

HeapTrap::HeapTrap() noexcept : calls_before_{calls_of_this_thread} {}
long HeapTrap::calls() const noexcept { return calls_of_this_thread - calls_before_; }
bool HeapTrap::works() noexcept { return ARTICAM_OWN_HEAP != 0; }

}  // namespace articam::test
