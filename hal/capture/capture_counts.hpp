#pragma once
/// @file  What became of the frames that did not reach the loop as they came.

#include <cstdint>

namespace articam::hal {

/// Since the camera object was made. Where a device does not know a state, its count stays 0.
struct CaptureCounts {
  std::uint64_t overtaken{};     ///< good frames that a newer one replaced before the loop took them
  std::uint64_t starting_up{};   ///< refused: exposure had not settled
  std::uint64_t corrupt{};       ///< refused: marked so by library or driver
  std::uint64_t cancelled{};     ///< refused: the capture was ending
  std::uint64_t wrong_size{};    ///< refused: shorter than the image
  std::uint64_t wrong_stamp{};   ///< refused: of another clock, older than max_age or of the future
  std::uint64_t out_of_order{};  ///< refused: exposed no later than the frame before it
  std::uint64_t copied{};        ///< lent as a copy; see the camera's description()
};

}  // namespace articam::hal
