#pragma once
/// @file  From the board's clock to one of the host's, by packets that go one way only.

#include <algorithm>
#include <cstdint>
#include <limits>

namespace articam::listen {

/// The quickest packet of the last half to whole minute says how far the clocks are apart, too much by its own time on
/// the way: nothing better can be known without an answer to the board. Older packets are forgotten, because crystals
/// drift by up to some milliseconds a minute and somebody may set the host's clock.
class ClockMap {
 public:
  void take(std::int64_t sent_ns, std::int64_t received_ns) noexcept {
    const std::int64_t offset_ns = minus(received_ns, sent_ns);
    if (!any_ || minus(received_ns, since_ns_) > kHalf_ns || received_ns < since_ns_) {
      before_ns_ = any_ ? now_ns_ : kNone;
      now_ns_ = kNone;
      since_ns_ = received_ns;
      any_ = true;
    }
    now_ns_ = std::min(now_ns_, offset_ns);
  }

  /// Host's minus board's, ns. Only after take().
  std::int64_t offset_ns() const noexcept { return std::min(before_ns_, now_ns_); }
  std::int64_t to_host_ns(std::int64_t board_ns) const noexcept { return minus(offset_ns(), minus(0, board_ns)); }

  /// a - b that wraps: a board may claim any time.
  static constexpr std::int64_t minus(std::int64_t a, std::int64_t b) noexcept {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
  }

 private:
  static constexpr std::int64_t kHalf_ns = 30'000'000'000;
  static constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::max();

  bool any_{};
  std::int64_t since_ns_{};                        ///< when the present half minute began
  std::int64_t now_ns_{kNone}, before_ns_{kNone};  ///< smallest offset of this and of the last half minute
};

}  // namespace articam::listen
