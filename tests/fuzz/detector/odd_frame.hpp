#pragma once
/// @file  Any bytes -> a frame with marks, texture and damage, in a buffer of exactly the bytes that may be read.

#include <fuzzer/FuzzedDataProvider.h>

#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/vision/image_view.hpp"

namespace articam::fuzz {

/// Rows of `stride` bytes, of which the last one ends with its last pixel: the address sanitizer sees what is read
/// beyond. Between the rows lies `padding`.
class OddFrame {
 public:
  OddFrame(int width_px, int height_px, int stride_bytes, std::uint8_t padding);

  ImageView view() const noexcept { return {pixels_.get(), width_px_, height_px_, stride_bytes_}; }
  int width_px() const noexcept { return width_px_; }
  int height_px() const noexcept { return height_px_; }
  std::uint8_t& at(int u_px, int v_px) noexcept { return pixels_[offset(u_px, v_px)]; }

  /// The same picture, with other bytes between the rows.
  OddFrame with_padding(std::uint8_t padding) const;

 private:
  std::size_t offset(int u_px, int v_px) const noexcept {
    return static_cast<std::size_t>(v_px) * static_cast<std::size_t>(stride_bytes_) + static_cast<std::size_t>(u_px);
  }

  int width_px_, height_px_, stride_bytes_;
  std::unique_ptr<std::uint8_t[]> pixels_;
};

/// Mostly a small frame with a few soft ellipses, so that many of them are rings and dots, or nearly.
OddFrame odd_frame(FuzzedDataProvider& bytes);

}  // namespace articam::fuzz
