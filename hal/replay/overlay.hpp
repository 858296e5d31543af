#pragma once
/// @file  A frame with what was seen in it and what the model expected, as a picture for a person.

#include <filesystem>
#include <string>
#include <vector>

#include "core/status.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/image_view.hpp"

namespace articam::hal {

/// What to draw over a frame. Pixel centres are integers.
struct Overlay {
  struct Predicted {
    std::string name;
    double u_px{}, v_px{}, radius_px{};
    bool matched{};
  };
  std::vector<vision::Detection> seen;  ///< outlined in yellow
  std::vector<Predicted> predicted;     ///< a cross: green when matched, red when not
  std::string caption;
};

/// Writes a PNG, twice the frame's size. Errors  io_error; `why` says what is wrong.
Status write_overlay(const std::filesystem::path& path, const ImageView& image, const Overlay& overlay,
                     std::string& why);

}  // namespace articam::hal
