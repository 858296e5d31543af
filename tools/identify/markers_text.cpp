#include "tools/identify/markers_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace articam::identify {
namespace {

/// What the detector needs to know of a mark.
std::string mark(const modelgen::Marker& marker) {
  if (marker.kind == model::MarkerKind::ring) {
    return fmt::format("type: ring, outer_diameter_m: {}, inner_diameter_m: {}", marker.outer_diameter_m,
                       marker.inner_diameter_m);
  }
  const bool light = marker.kind == model::MarkerKind::dot_light_on_dark;
  return fmt::format("type: dot, diameter_m: {}, polarity: {}", marker.outer_diameter_m,
                     light ? "light_on_dark" : "dark_on_light");
}

/// A name as YAML takes any: in single quotes, which are written twice inside.
std::string quoted(const std::string& name) {
  std::string text{'\''};
  for (const char c : name) text += c == '\'' ? "''" : std::string(1, c);
  return text + '\'';
}

std::string remark(const MarkerPlace& place, const Vec3& deviation_m) {
  if (!place.seen) return "not seen";
  return fmt::format("+- {:.3f} {:.3f} {:.3f} mm{}", 1e3 * deviation_m[0], 1e3 * deviation_m[1], 1e3 * deviation_m[2],
                     place.reference ? "" : ", displaced");
}

}  // namespace

std::string markers_text(const modelgen::MarkersFile& file, const std::vector<MarkerPlace>& places,
                         const std::vector<Mat3>& R_body_link, const std::optional<std::vector<double>>& q0) {
  std::string text =
      "# Places identified from a recording by articam-replay, with the standard deviations along the frame's axes.\n"
      "markers:\n";
  for (std::size_t i = 0; i < file.markers.size(); ++i) {
    const modelgen::Marker& marker = file.markers[i];
    const Mat3 R_link_body = R_body_link[i].transpose();
    const Vec3 moved = R_link_body * places[i].displaced;
    const Vec3 deviation =
        (R_link_body * places[i].covariance * R_link_body.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
    const auto& o = marker.offset_m;
    text +=
        fmt::format("  # {}\n  - {{frame: {}, {}, offset_m: [{:.7f}, {:.7f}, {:.7f}]}}\n", remark(places[i], deviation),
                    quoted(marker.frame), mark(marker), o[0] + moved[0], o[1] + moved[1], o[2] + moved[2]);
  }
  if (q0) text += fmt::format("q0: [{}]\n", fmt::join(*q0, ", "));
  return text;
}

}  // namespace articam::identify
