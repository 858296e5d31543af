#pragma once
/// @file  Packets on a serial line: frames without a zero inside and one zero after them.
///
/// Source  Cheshire & Baker, "Consistent Overhead Byte Stuffing", IEEE/ACM Transactions on Networking 7(2), 1999.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/status.hpp"

namespace articam::wire {

/// The largest frame, its delimiter included, for so many bytes.
constexpr std::size_t cobs_frame_size(std::size_t size) noexcept { return size + size / 254 + 2; }

/// The frame of `bytes`, its delimiter included, and its size.
/// Errors  bad_argument when `frame` is smaller than cobs_frame_size(bytes.size()).
constexpr Result<std::size_t> cobs_encode(std::span<const std::uint8_t> bytes, std::span<std::uint8_t> frame) noexcept {
  if (frame.size() < cobs_frame_size(bytes.size()))
    return articam::Status::bad_argument;  // protobuf has its own wire::Status
  std::size_t code = 0, end = 1;           // where the present block's length goes, and the frame's end so far
  for (const std::uint8_t byte : bytes) {
    if (end - code == 0xff) {  // a full block has no zero behind it
      frame[code] = 0xff;
      code = end++;
    }
    if (byte != 0) {
      frame[end++] = byte;
    } else {
      frame[code] = static_cast<std::uint8_t>(end - code);
      code = end++;
    }
  }
  frame[code] = static_cast<std::uint8_t>(end - code);
  frame[end++] = 0;
  return end;
}

/// Takes a stream byte by byte and gives back what lay between two delimiters. After noise, a torn or an over-long
/// frame it is in step again at the next delimiter.
template <std::size_t Capacity>
class CobsDecoder {
 public:
  enum class Event : std::uint8_t {
    none,
    frame,   ///< frame() is whole, until the next call of take()
    broken,  ///< what the delimiter has ended was no frame, or larger than Capacity
  };

  constexpr Event take(std::uint8_t byte) noexcept {
    if (ended_) restart();
    if (byte == 0) return end();
    if (overflowed_) return Event::none;
    if (left_ > 0) {
      put(byte);
      --left_;
    } else {
      if (zero_due_) put(0);
      begun_ = true;
      left_ = byte - 1u;
      zero_due_ = byte != 0xff;
    }
    return Event::none;
  }
  constexpr std::span<const std::uint8_t> frame() const noexcept { return {bytes_.data(), size_}; }

 private:
  constexpr void restart() noexcept {
    size_ = left_ = 0;
    begun_ = ended_ = zero_due_ = overflowed_ = false;
  }
  constexpr Event end() noexcept {
    ended_ = true;
    if (!begun_) return Event::none;  // delimiters in a row
    return left_ == 0 && !overflowed_ ? Event::frame : Event::broken;
  }
  constexpr void put(std::uint8_t byte) noexcept {
    if (size_ == Capacity) {
      overflowed_ = true;
    } else {
      bytes_[size_++] = byte;
    }
  }

  std::array<std::uint8_t, Capacity> bytes_{};
  std::size_t size_{};
  std::size_t left_{};  ///< bytes until the present block ends
  bool begun_{}, ended_{}, zero_due_{}, overflowed_{};
};

}  // namespace articam::wire
