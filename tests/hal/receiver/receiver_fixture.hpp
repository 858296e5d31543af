#pragma once
/// @file  A receiver on loopback, and a board that is made up.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <thread>

#include "hal/receiver/receiver.hpp"
#include "tests/support/udp_ear.hpp"
#include "tests/support/wire_messages.hpp"

namespace articam::test {

/// Captured 20 ms before it was sent; the first joint moves at 1 m/s.
inline wire::EstimateMessage moving(std::uint32_t number) {
  Random random{51};
  wire::EstimateMessage m = random_estimate(random);
  m.session = 1, m.number = number, m.model_hash = 9;
  m.t_capture = {123'000'000'000}, m.t_send = {123'020'000'000};  // the board's clock, far from ours
  m.status = tracker::TrackingStatus::tracking;
  m.joints[0] = 0.1, m.velocity[6] = 1;
  return m;
}

/// Waits up to 5 s for a state that must come; the law is in the state, not in the time.
template <class Condition>
bool comes(Condition condition) {
  for (int k = 0; k < 5000 && !condition(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds{1});
  return condition();
}

class ReceiverTest : public testing::Test {
 protected:
  void start() {
    options_.address = "udp://127.0.0.1:" + std::to_string(port_);
    ASSERT_EQ(receiver_.start(options_), Status::ok) << receiver_.problem();
  }
  void send(const wire::EstimateMessage& m) { ASSERT_TRUE(sender_.say(packet_of(m), port_)); }
  bool hears(std::uint32_t number) {
    return comes([&] { return receiver_.newest().estimate.number == number; });
  }

  const std::uint16_t port_ = UdpEar{}.port();
  receiver::Options options_;
  receiver::Receiver receiver_;
  UdpEar sender_;
};

}  // namespace articam::test
