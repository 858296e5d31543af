#pragma once
/// @file  The firmware over the drawn recording, one line of hashes a frame: the same lines on every machine.

#include <array>
#include <cstdint>

#include "hal/baremetal/line.hpp"
#include "hal/firmware.hpp"
#include "tests/bits/scene.hpp"
#include "tests/bits/state_hash.hpp"

namespace articam::test {

/// One bit of one pixel that the recording does not have, to see that it is found; bit 0 .. 7, or none.
struct Flip {
  std::uint32_t frame{};
  int u_px{}, v_px{};
  int bit{-1};
};
/// The lowest bit of a pixel on the edge of a ring.
inline constexpr Flip kEdgeFlip{50, 241, 301, 0};

/// A few hundred kilobytes, for static memory.
class BitsRun {
 public:
  /// Calls `print(const hal::Line&)`: for each frame `frame 12 pixels H float H H double H H`, the hashes of its pixels
  /// and, for each scalar, of the detections and of the estimate; then `detections FLOAT DOUBLE`, how many those were.
  template <class Print>
  void run(const Flip& flip, Print&& print) noexcept {
    std::size_t of_float = 0, of_double = 0;
    for (std::uint32_t k = 0; k < Scene::kFrames; ++k) {
      const ImageView image = Scene::draw(k, pixels_);
      if (flip.bit >= 0 && flip.frame == k) {
        pixels_[static_cast<std::size_t>(flip.v_px * Scene::kWidth_px + flip.u_px)] ^=
            static_cast<std::uint8_t>(1U << flip.bit);
      }
      const Timestamp t = from_seconds(k / Scene::kRate_hz);
      hal::Line line;
      line << "frame " << k << " pixels " << hal::hex(hash_of(pixels_)) << " float";
      add(in_float_, image, t, line);
      line << " double";
      add(in_double_, image, t, line);
      of_float += in_float_.detections().size();
      of_double += in_double_.detections().size();
      print(line << '\n');
    }
    hal::Line line;
    print(line << "detections " << of_float << ' ' << of_double << '\n');
  }

 private:
  using Model = models::PrinterDrawer;

  template <class S>
  static void add(tracker::Tracker<Model, S>& tracker, const ImageView& image, Timestamp t, hal::Line& line) noexcept {
    const auto estimate = tracker.step(image, t);
    line << ' ' << hal::hex(hash_of(tracker.detections())) << ' ' << hal::hex(hash_of(estimate));
  }

  tracker::Tracker<Model, float> in_float_{Scene::camera()};
  tracker::Tracker<Model, double> in_double_{Scene::camera()};
  std::array<std::uint8_t, Scene::kPixels> pixels_{};
};

}  // namespace articam::test
