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
  struct Seen {
    vision::Detection mark;  ///< both edges, sub-pixel: rings yellow, light dots blue, dark dots magenta
    std::string note;        ///< beside it, after the names of its flaws
  };
  struct Predicted {
    std::string name;         ///< beside it
    vision::Ellipse outline;  ///< dashed
    bool matched{};           ///< green; red where not
    std::string why_not;      ///< follows the name
  };
  std::vector<Seen> seen{};
  std::vector<Predicted> predicted{};
  std::string caption{};
};

/// "blurred saturated clipped occluded", as far as they are set.
std::string names_of_flaws(unsigned flaws);

/// Writes a PNG, whole or not at all; the frame is enlarged so that a pixel can be told from the next.
/// Errors  bad_argument, io_error; `why` says what is wrong.
Status write_overlay(const std::filesystem::path& path, const ImageView& image, const Overlay& overlay,
                     std::string& why);

}  // namespace articam::hal
