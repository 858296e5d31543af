#include "tools/identify/report.hpp"

#include <fmt/format.h>

#include <cmath>

namespace articam::identify {
namespace {

std::string length_line(const Length& length) {
  if (length.slides) {
    return fmt::format("  {:<20} {:.3f} mm +- {:.3f} mm\n", length.joint, 1e3 * length.value, 1e3 * length.deviation);
  }
  constexpr double kDeg = 180 / 3.14159265358979323846;
  return fmt::format("  {:<20} {:.4f} deg +- {:.4f} deg\n", length.joint, kDeg * length.value, kDeg * length.deviation);
}

std::string place_line(const MarkerPlace& place) {
  if (!place.seen) return fmt::format("  {:<20} not seen\n", place.marker);
  const Vec3 mm = 1e3 * place.displaced, deviation = 1e3 * place.covariance.diagonal().cwiseMax(0).cwiseSqrt();
  return fmt::format("  {:<20} {:+.3f} {:+.3f} {:+.3f} +- {:.3f} {:.3f} {:.3f}{}\n", place.marker, mm[0], mm[1], mm[2],
                     deviation[0], deviation[1], deviation[2], place.reference ? "" : "   displaced");
}

std::string places_text(const Findings& findings) {
  if (findings.places.empty()) return {};
  std::string text = "markers' places, mm from where the model has them, along the axes of their bodies\n";
  for (const MarkerPlace& place : findings.places) text += place_line(place);
  if (findings.num_held == 0) return text;
  return text + fmt::format(
                    "  {} directions cannot be told and are held so that most markers stay where they are: all\n"
                    "  markers shifted or turned together, the zero of a joint, the overall scale\n",
                    findings.num_held);
}

const char* name_of(Judgement::Part part) {
  switch (part) {
    case Judgement::Part::focal_length:
      return "focal length";
    case Judgement::Part::aspect:
      return "fy / fx";
    case Judgement::Part::principal_x:
      return "principal point, x";
    case Judgement::Part::principal_y:
      return "principal point, y";
    case Judgement::Part::distortion:
      return "distortion";
  }
  return "";
}

/// A length of that part, with its unit; of the lens, where a mark is seen farthest out.
std::string amount(const Judgement& judgement, double value) {
  const bool share = judgement.part == Judgement::Part::focal_length || judgement.part == Judgement::Part::aspect;
  return share ? fmt::format("{:.2g} %", 100 * value) : fmt::format("{:.2g} px", value);
}

/// What the file's number is, of which the truth is `error` more.
const char* wrong_how(const Judgement& judgement) {
  const bool more = judgement.error < 0;
  switch (judgement.part) {
    case Judgement::Part::focal_length:
      return more ? "too long" : "too short";
    case Judgement::Part::aspect:
      return more ? "too large" : "too small";
    case Judgement::Part::principal_x:
      return more ? "too far right" : "too far left";
    case Judgement::Part::principal_y:
      return more ? "too far down" : "too far up";
    case Judgement::Part::distortion:
      return more ? "too far out at the outermost mark" : "too far in at the outermost mark";
  }
  return "";
}

std::string judgement_line(const Judgement& judgement, const std::string& file) {
  const char* const part = name_of(judgement.part);
  if (!judgement.told) return fmt::format("  {:<20} not told by this recording\n", part);
  if (!judgement.wrong())
    return fmt::format("  {:<20} agrees, within {}\n", part, amount(judgement, 2 * judgement.deviation));
  return fmt::format("  {:<20} of {} is {} {} ({:.0f} sigma): calibrate again\n", part, file,
                     amount(judgement, std::abs(judgement.error)), wrong_how(judgement), judgement.significance());
}

}  // namespace

std::string to_text(const Findings& findings, const std::string& camera_file) {
  std::string text = fmt::format("identified from {} moments, {} sightings ({} far off), rms {:.3f} px\n",
                                 findings.num_moments, findings.num_sightings, findings.num_outliers, findings.rms_px);
  for (const Length& length : findings.lengths) text += length_line(length);
  text += places_text(findings);
  text += "camera\n";
  for (const Judgement& judgement : findings.camera) text += judgement_line(judgement, camera_file);
  constexpr double kFarAbove = 5;
  if (findings.noise > kFarAbove) {
    text += fmt::format(
        "residuals are {:.0f} times what the detector promises: a marker is not where the model has it, or a joint\n"
        "that moved was taken for a constant{}\n",
        findings.noise, findings.places.empty() ? "; --identify FILE.yaml finds displaced markers" : "");
  }
  return text;
}

}  // namespace articam::identify
