#pragma once
/// @file  A link that writes one line an estimate onto the console.

#include "core/status.hpp"
#include "hal/baremetal/line.hpp"
#include "hal/baremetal/semihosting.hpp"

namespace articam::hal {

/// `frame 12 tracking none matched 6 t_um 20000 80000 700000 joints_u 53000 120000`: the base's position in micrometres
/// and the joints in micrometres or microradians, so that no library has to print a float. It stands for a UART or a
/// network interface: a real one sends the packets of hal/wire, as hal/link does.
template <class Estimate>
class ConsoleLink {
 public:
  Status publish(const Estimate& estimate) noexcept {
    Line line;
    line << "frame " << estimate.frame << ' ' << name(estimate.status) << ' ' << name(estimate.reason) << " matched "
         << estimate.matched;
    if (estimate.valid) {
      line << " t_um";
      for (const auto x : estimate.q.T_cam_obj.t) line << ' ' << micro(x);
      line << " joints_u";
      for (const auto x : estimate.q.joints) line << ' ' << micro(x);
    }
    semihosting::write((line << '\n').text());
    if (estimate.status == decltype(estimate.status)::tracking) ++tracked_;
    return Status::ok;
  }
  std::uint32_t tracked() const noexcept { return tracked_; }  ///< estimates with status tracking

 private:
  /// Rounded; held at +-2000 where the number is farther out.
  template <class S>
  static std::int32_t micro(S x) noexcept {
    constexpr S kFar{2000};
    const S held = x < -kFar ? -kFar : (x > kFar ? kFar : x);
    return static_cast<std::int32_t>(held * S(1e6) + (held < S(0) ? S(-0.5) : S(0.5)));
  }

  std::uint32_t tracked_{};
};

}  // namespace articam::hal
