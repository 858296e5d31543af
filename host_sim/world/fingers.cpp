#include "host_sim/world/fingers.hpp"

#include <algorithm>
#include <cmath>

namespace articam::sim {

Vec6 Fingers::force(const HandAtHandle& hand) noexcept {
  Vec6 out;
  for (int i = 0; i < 3; ++i) {
    const double way = hand.offset_m[i] - slipped_m_[i];
    double pressed = std::max(std::abs(way) - 0.5 * options_.play_m[i], 0.0);
    const double sign = way < 0 ? -1 : 1;
    const double most = options_.slip_force / options_.stiffness;
    if (pressed > most) {
      slipped_m_[i] += sign * (pressed - most);
      pressed = most;
    }
    // They push and never pull; what damps them slips, too.
    const double push = pressed > 0 ? options_.stiffness * pressed + options_.damping * sign * hand.rate[i] : 0;
    out[i] = sign * std::clamp(push, 0.0, options_.slip_force);
  }
  out.tail<3>() = options_.turn_stiffness * hand.turn_rad + options_.turn_damping * hand.rate.tail<3>();
  return out;
}

}  // namespace articam::sim
