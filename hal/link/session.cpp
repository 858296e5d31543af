#include "hal/link/session.hpp"

#include <sys/random.h>

#include "hal/posix/monotonic_clock.hpp"

namespace articam::hal {

std::uint64_t draw_session() noexcept {
  std::uint64_t session = 0;
  if (::getrandom(&session, sizeof session, GRND_NONBLOCK) != sizeof session) {
    // The kernel has not gathered randomness yet, early after power-on: the clock differs from start to start too.
    session = static_cast<std::uint64_t>(MonotonicClock{}.now().ns);
  }
  return session != 0 ? session : 1;
}

}  // namespace articam::hal
