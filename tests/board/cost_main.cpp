/// @file  What cost.sh measures on a board: named pieces of work between two marks, and the stack that they used.

#include <array>
#include <cstdint>

#include "hal/baremetal/fault.hpp"
#include "hal/baremetal/semihosting.hpp"
#include "tests/bits/bits_run.hpp"

extern "C" {
extern std::uint32_t articam_stack_bottom;  // from the linker script
// Marks for instruction_counter.cpp.
[[gnu::noinline]] void articam_measure_begin() { asm volatile(""); }
[[gnu::noinline]] void articam_measure_end() { asm volatile(""); }
}

namespace articam::test {
namespace {

using Tracker = tracker::Tracker<models::PrinterDrawer, float>;

Tracker stepper{Scene::camera()}, solver{Scene::camera()};  // solver is given what stepper has detected
Tracker::EstimateType estimate;
std::array<std::uint8_t, Scene::kPixels> pixels;
constexpr std::uint32_t kUnused = 0xA5A5A5A5;

const std::uint32_t* stack_pointer() {
  const std::uint32_t* here = nullptr;
  asm volatile("mov %0, sp" : "=r"(here));
  return here;
}
void paint_stack() {
  for (volatile std::uint32_t* word = &articam_stack_bottom; word < stack_pointer(); ++word) *word = kUnused;
}
/// Below the caller's frame, since paint_stack().
std::uint32_t stack_used_bytes() {
  const volatile std::uint32_t* word = &articam_stack_bottom;
  while (word < stack_pointer() && *word == kUnused) ++word;
  return 4 * static_cast<std::uint32_t>(stack_pointer() - word);
}

template <class Work>
void measure(const char* name, Work&& work) {
  paint_stack();
  articam_measure_begin();
  work();
  articam_measure_end();
  hal::Line line;
  hal::semihosting::write((line << name << ' ' << stack_used_bytes() << '\n').text());
}

}  // namespace
}  // namespace articam::test

int main() {
  using namespace articam;
  using namespace articam::test;
  constexpr std::uint32_t kMeasured = 20;  // long after the first frames; all six rings are in sight

  for (std::uint32_t k = 0; k <= kMeasured; ++k) {
    const ImageView image = Scene::draw(k, pixels);
    const Timestamp t = from_seconds(k / Scene::kRate_hz);
    const auto step = [&] { estimate = stepper.step(image, t); };
    const auto solve = [&] { (void)solver.step(stepper.detections(), {}, t); };
    if (k == 0) {
      measure("first_frame", step);
      solve();
    } else if (k == kMeasured) {
      measure("tracked_step", step);
      measure("tracked_solve", solve);
    } else {
      step(), solve();
    }
  }
  if (estimate.status != tracker::TrackingStatus::tracking || estimate.matched != 6) {
    hal::stop_with_fault("the measured step does not track six rings");
  }
  return 0;
}
