/// @file  What the link costs: an estimate to a packet on the board, a packet to an estimate at the controller.

#include <benchmark/benchmark.h>

#include "hal/link/packet_link.hpp"
#include "hal/memory/manual_clock.hpp"
#include "hal/receiver/intake.hpp"
#include "hal/receiver/prediction.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;
using Estimate = tracker::Estimate<M, double>;

/// Keeps the newest packet.
struct Carrier {
  Status send(std::span<const std::uint8_t> packet) noexcept {
    std::ranges::copy(packet, bytes.begin());
    size = packet.size();
    return Status::ok;
  }
  std::array<std::uint8_t, wire::kMaxPacketSize> bytes{};
  std::size_t size{};
};

Estimate estimate() {
  Estimate e;
  e.valid = true;
  e.covariance.setConstant(1e-6);
  return e;
}

void publish(benchmark::State& state) {
  Carrier carrier;
  const hal::ManualClock clock;
  hal::PacketLink<Estimate, Carrier, hal::ManualClock> link{carrier, clock, {CameraParameters{}, 1, 30}};
  const Estimate e = estimate();
  for (auto _ : state) benchmark::DoNotOptimize(link.publish(e));
  state.counters["packet_bytes"] = static_cast<double>(carrier.size);
}

void receive(benchmark::State& state) {
  Carrier carrier;
  const hal::ManualClock clock;
  hal::PacketLink<Estimate, Carrier, hal::ManualClock> link{carrier, clock, {CameraParameters{}, 1, 30}};
  (void)link.publish(estimate());
  const std::span<const std::uint8_t> packet{carrier.bytes.data(), carrier.size};
  receiver::Intake intake;
  // A duplicate is opened and read like every packet, and only then put aside.
  for (auto _ : state) benchmark::DoNotOptimize(intake.take(packet, {}));
}

void predict(benchmark::State& state) {
  wire::EstimateMessage m = hal::ToMessage<M>{CameraParameters{}, 1, 30}.estimate(estimate());
  for (auto _ : state) benchmark::DoNotOptimize(receiver::predict(m, 0.01));
}

BENCHMARK(publish)->Name("link/publish/PrinterDrawer");
BENCHMARK(receive)->Name("link/receive/PrinterDrawer");
BENCHMARK(predict)->Name("link/predict/PrinterDrawer");

}  // namespace
}  // namespace articam
