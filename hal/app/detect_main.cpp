/// @file  articam-detect: which rings and dots the firmware's detector sees in recorded frames, as CSV.

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "core/vision/detector.hpp"
#include "hal/replay/overlay.hpp"
#include "hal/replay/pgm.hpp"

namespace {

using namespace articam;

constexpr const char* kExamples = R"(
Examples
  articam-detect --type ring frame_*.pgm > marks.csv
  articam-detect --type dot --overlay seen frame_0007.pgm     what was seen, in seen/overlay_00000_frame_0007.png
  articam-detect --type ring --ring-ratio 0.5 frame.pgm       rings whose hole is half as wide

In a picture, each edge is outlined where it was measured, to a fraction of a pixel. Words beside a mark: blurred (its
edge is wider than 1.5 px), saturated (its light is at the end of the grey levels), clipped (its dark is), occluded
(up to an eighth of its edge is hidden), and its diameter.
Exit codes: 0 done, 1 a frame is refused or the job failed, 2 wrong usage.)";

const char* name(vision::MarkKind kind) {
  switch (kind) {
    case vision::MarkKind::ring:
      return "ring";
    case vision::MarkKind::dot_light_on_dark:
      return "dot_light_on_dark";
    case vision::MarkKind::dot_dark_on_light:
      return "dot_dark_on_light";
  }
  return "unknown";
}

struct Axes {
  double major_px, minor_px, angle_rad;
};

// Principal axes of M M^T: full lengths, and the major axis's angle from +x towards +y in (-pi/2, pi/2].
Axes axes_of(const vision::Ellipse& e) {
  const double m00 = vision::from_q16(e.m00_q16), m10 = vision::from_q16(e.m10_q16), m11 = vision::from_q16(e.m11_q16);
  const double uu = m00 * m00, uv = m00 * m10, vv = m10 * m10 + m11 * m11;
  const double mean = (uu + vv) / 2, half_difference = std::hypot((uu - vv) / 2, uv);
  double angle = std::atan2(2 * uv, uu - vv) / 2;
  if (angle <= -std::numbers::pi / 2) angle = std::numbers::pi / 2;
  return {2 * std::sqrt(mean + half_difference), 2 * std::sqrt(mean - half_difference), angle};
}

// A field of RFC 4180: quoted only where it must be.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

vision::DetectorOptions options_for(const std::string& type, double ring_ratio) {
  vision::DetectorOptions options;
  options.rings = type != "dot";
  options.dots_light_on_dark = options.dots_dark_on_light = type != "ring";
  options.ring_ratio_q16 = static_cast<std::int32_t>(std::lround(ring_ratio * 65536));
  return options;
}

/// A picture of what was seen in a frame; `number` tells frames of the same name apart. Returns what went wrong.
std::string draw(const std::filesystem::path& folder, std::size_t number, const std::filesystem::path& file,
                 const ImageView& image, const vision::Detections& marks, bool overloaded) {
  hal::Overlay overlay;
  for (const vision::Detection& mark : marks) {
    overlay.seen.push_back({mark, fmt::format("{:.1f} px", axes_of(mark.outer).major_px)});
  }
  overlay.caption = fmt::format(
      "{}   {} mark{}{}   yellow: ring   blue: dot, light on dark   magenta: dot, dark on light",
      file.filename().string(), marks.size(), marks.size() == 1 ? "" : "s", overloaded ? ", overloaded" : "");
  const auto picture = folder / fmt::format("overlay_{:05}_{}.png", number, file.stem().string());
  std::string why;
  (void)hal::write_overlay(picture, image, overlay, why);  // empty when drawn
  return why;
}

int fail(const std::string& message) {
  fmt::print(stderr, "articam-detect: {}\n", message);
  return 1;
}

int run(const std::vector<std::string>& files, const vision::DetectorOptions& options, const std::string& folder) {
  const auto detector = std::make_unique<vision::Detector>(options);
  int result = 0;
  std::cout << "file,type,x_px,y_px,major_px,minor_px,angle_rad\n";
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string& file = files[i];
    hal::GreyImage image;
    vision::Detections marks;
    std::string why;
    Status status = hal::read_pgm(file, image, why);
    if (status == Status::ok) status = detector->detect(image.view(), marks);
    if (status != Status::ok) {
      result = fail(why);
      continue;
    }
    if (detector->overloaded()) fail(file + ": more structure than the detector's capacity; marks may be missing");
    for (const vision::Detection& mark : marks) {
      const Axes axes = axes_of(mark.outer);
      std::cout << fmt::format("{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.5f}\n", csv_field(file), name(mark.kind),
                               vision::from_q16(mark.outer.u_q16), vision::from_q16(mark.outer.v_q16), axes.major_px,
                               axes.minor_px, axes.angle_rad);
    }
    if (folder.empty()) continue;
    if (why = draw(folder, i, file, image.view(), marks, detector->overloaded()); !why.empty()) return fail(why);
  }
  if (!std::cout.flush()) return fail("standard output could not be written in full; is its disk full?");
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Finds ring and dot markers in 8-bit PGM frames and prints one CSV row for each.\n"
      "x_px, y_px: centre of the outer ellipse; pixel centres are integers, (0,0) is the centre of the top-left "
      "pixel.\n"
      "major_px, minor_px: full axes of the outer ellipse; angle_rad: of the major axis, from +x towards +y.\n"
      "Rings are found from 12 px across, dots from 7 px.",
      "articam-detect"};
  app.set_version_flag("--version", ARTICAM_VERSION);
  app.footer(kExamples);
  std::string type = "all", overlay_folder;
  double ring_ratio = 50.0 / 122.0;
  std::vector<std::string> files;
  app.add_option("--type", type, "what to look for")
      ->check(CLI::IsMember({"ring", "dot", "all"}))
      ->capture_default_str();
  app.add_option("--ring-ratio", ring_ratio, "inner : outer diameter of the rings")
      ->check(CLI::Range(vision::from_q16(vision::kMinRingRatio_q16), vision::from_q16(vision::kMaxRingRatio_q16)))
      ->capture_default_str();
  app.add_option("--overlay", overlay_folder, "also draw every frame with its marks into this folder (PNG)");
  app.add_option("FRAME.pgm", files, "binary 8-bit PGM files")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::error_code error;
  if (!overlay_folder.empty()) std::filesystem::create_directories(overlay_folder, error);
  if (error) return fail(overlay_folder + ": " + error.message());
  return run(files, options_for(type, ring_ratio), overlay_folder);
}
