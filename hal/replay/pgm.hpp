#pragma once
/// @file  Grey images in files: the binary 8-bit PGM format (netpbm "P5").

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/status.hpp"
#include "core/vision/image_view.hpp"

namespace articam::hal {

/// A grey image with its own storage, rows without gaps.
struct GreyImage {
  int width_px{}, height_px{};
  std::vector<std::uint8_t> pixels;

  ImageView view() const noexcept { return {pixels.data(), width_px, height_px, width_px}; }
};

/// Reads one binary PGM of at most kMaxImageWidth_px x kMaxImageHeight_px with a maximum value of 1 to 255; grey
/// levels are scaled so that the maximum becomes 255. Bytes after the first image are ignored, as netpbm allows
/// several in a file.
/// Errors  io_error (cannot be read), bad_argument (not such an image); `why` then names the file and says what is
///         wrong, `out` is unchanged.
Status read_pgm(const std::filesystem::path& path, GreyImage& out, std::string& why);

/// Writes a binary PGM whole or not at all: into a temporary file beside it, which is then renamed.
/// Errors  bad_argument (the view may not be read), io_error; `why` names the file and says what is wrong.
Status write_pgm(const std::filesystem::path& path, const ImageView& image, std::string& why);

}  // namespace articam::hal
