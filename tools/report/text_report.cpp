#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tools/report/report.hpp"

namespace articam::report {
namespace {

/// A deviation for people: mm or deg, three digits.
std::string amount(double deviation, bool is_metres) {
  if (!std::isfinite(deviation)) return "-";
  return is_metres ? fmt::format("{:.3g} mm", 1e3 * deviation)
                   : fmt::format("{:.3g} deg", deviation * 180 / std::numbers::pi);
}

std::string percent(double share) {
  const double hundred = 100 * share;
  if (hundred > 0 && hundred < 1) return "<1 %";
  return fmt::format("{:.0f} %", hundred < 100 ? std::min(hundred, 99.0) : 100.0);
}

/// Columns padded to their widest cell, two blanks between.
std::string table_text(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("  {:<{}}", row[i], widths[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string head_text(const Report& r) {
  const Conditions& c = r.conditions;
  const std::size_t values = r.table.values().size();
  return fmt::format(
      "{}: what its marks will tell\n"
      "\n"
      "Camera {}x{}, focal length {:.0f} px. Range {:.2f} to {:.2f} m, tilt up to {:.0f} deg.\n"
      "Noise {:g} px on each coordinate of a mark's centre. Every deviation is the Cramer-Rao bound of the centres "
      "alone,\n"
      "without distortion: no estimator without bias does better. Marks hide behind nothing here.\n"
      "\n"
      "Model\n"
      "  {} links, {} joints: {} with a value of their own, {} that mimic, {} held, {} fixed, {} left out (no mark "
      "moves)\n"
      "  {} marks, {} degrees of freedom: 6 of the base, {} of joints\n",
      r.table.robot, c.camera.width_px, c.camera.height_px, c.camera.fx_px, c.min_range_m, c.max_range_m,
      c.max_tilt_deg, c.noise_px, r.num_links, r.num_joints, values, r.num_mimics, r.table.frozen.size(), r.num_fixed,
      r.num_left_out, r.sizes.size(), 6 + values, values);
}

std::string sizes_text(const Report& r) {
  std::vector<std::vector<std::string>> rows{{"mark", fmt::format("at {:.2f} m", r.conditions.min_range_m),
                                              fmt::format("at {:.2f} m", r.conditions.max_range_m),
                                              fmt::format("{:.0f} px up to", kMinDiameter_px), ""}};
  for (const Size& s : r.sizes) {
    const bool small = s.farthest_px < kMinDiameter_px;
    rows.push_back({s.marker, fmt::format("{:.0f} px", s.nearest_px), fmt::format("{:.0f} px", s.farthest_px),
                    fmt::format("{:.2f} m", s.max_range_m), small ? "TOO SMALL for the range" : ""});
  }
  return "\nMarks: how large they appear, face to face\n" + table_text(rows);
}

/// `weak` as a warning where a joint, or a number of the base, is far from what its marks could tell.
std::string verdict(const Freedom& f, bool is_joint) {
  if (f.share_observed == 0) return "NEVER OBSERVED";
  return is_joint && f.worst_dilution > kWeakDilution ? "WEAK in " + percent(f.share_weak) : "";
}

std::string freedoms_text(const Report& r) {
  std::vector<std::vector<std::string>> rows{{"", "observed", "median", "worst", "at q0", ""}};
  const auto& all = r.over_views.freedoms;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Freedom& f = all[i];
    std::string start = "-";
    if (r.at_start) {
      const auto at = static_cast<Eigen::Index>(i);
      start = r.at_start->observed[i] ? amount(r.at_start->deviation[at], f.is_metres) : "not observed";
      if (i >= 6 && r.at_start->dilution[at] > kWeakDilution && r.at_start->observed[i]) start += " WEAK";
    }
    rows.push_back({f.name, percent(f.share_observed), amount(f.median, f.is_metres), amount(f.worst, f.is_metres),
                    start, verdict(f, i >= 6)});
  }
  std::string text = fmt::format(
      "\nDegrees of freedom over {} views: share of the views that observe them, standard deviation\n"
      "(tx ty tz rx ry rz: the base in the camera's frame)\n",
      r.views.size());
  text += table_text(rows);
  for (std::size_t i = 6; i < all.size(); ++i) {
    if (!(all[i].worst_dilution > kWeakDilution)) continue;
    text += fmt::format(
        "  {} is worst at {}:\n    {:.0f} times less certain than its marks could tell across the line of sight\n",
        all[i].name, describe(r.views[all[i].worst_view], r.table), all[i].worst_dilution);
  }
  text += fmt::format("  All of them are observed in {} of the views", percent(r.over_views.share_complete));
  if (r.over_views.share_complete == 0) return text + ".\n";
  return text + fmt::format("; there the least singular value is {:.3g} px a step of 1 cm, 1 deg,\n    at {}.\n",
                            r.over_views.least_singular_px,
                            describe(r.views[r.over_views.least_singular_view], r.table));
}

std::string losses_text(const Report& r) {
  std::vector<std::vector<std::string>> rows;
  for (const Loss& loss : r.over_views.losses) {
    std::vector<std::string> row{loss.marker};
    if (loss.num_views == 0) {
      row.emplace_back("is seen in none of the views");
    } else if (!loss.blinded.empty()) {
      row.push_back(fmt::format("NOT OBSERVED without it: {}", fmt::join(loss.blinded, " ")));
    } else {
      row.emplace_back("nothing is lost");
    }
    if (loss.growth > 1.005) row.push_back(fmt::format("{} {:.2f} times less certain", loss.worst_grown, loss.growth));
    rows.push_back(row);
  }
  return "\nWithout one mark\n" + table_text(rows);
}

std::string joints_text(const Report& r, const VectorX& joints) {
  std::string text;
  const auto values = r.table.values();
  for (std::size_t j = 0; j < values.size(); ++j) {
    text += fmt::format(" {} {:.3g}", values[j]->name, joints[static_cast<Eigen::Index>(j)]);
  }
  return text.empty() ? "" : " at" + text;
}

std::string symmetries_text(const Report& r) {
  std::string text = "\nLook-alikes, if marks carry no identities\n";
  if (r.symmetries.empty()) return text + "  none found: no other configuration puts the marks where they are\n";
  for (const Symmetry& s : r.symmetries) {
    text += fmt::format("  AMBIGUOUS{}: the base turned by {:.0f} deg{} looks the same ({:.1f} mm off)\n   ",
                        joints_text(r, s.joints), s.turn_deg, joints_text(r, s.other_joints), 1e3 * s.residual_m);
    for (std::size_t m = 0; m < s.takes_place_of.size(); ++m) {
      if (s.takes_place_of[m] == m) continue;
      text += fmt::format(" {}->{}", r.table.markers[m].name, r.table.markers[s.takes_place_of[m]].name);
    }
    text += '\n';
  }
  return text + "  A q0 in the markers file decides which is meant; better, move a mark, or give one another size.\n";
}

/// The angles that turn +z to the normal.
std::string rpy(const Vec3& normal) {
  const double roll = -std::asin(std::clamp(normal.y(), -1.0, 1.0)), pitch = std::atan2(normal.x(), normal.z());
  return fmt::format("{:.4f} {:.4f} 0", roll + 0.0, pitch + 0.0);
}

std::string advice_text(const Report& r) {
  std::string text = "\nOne more mark, where it would help most (see yourself whether the object is there)\n";
  const auto values = r.table.values();
  for (const Advice& a : r.advice) {
    const Vec3& p = a.candidate.place;
    const std::string where = a.candidate.name.empty() ? "" : fmt::format(" (--poi {})", a.candidate.name);
    text +=
        fmt::format("  on link {}{}: <origin xyz=\"{:.3f} {:.3f} {:.3f}\" rpy=\"{}\"/>, {:.2f} times more certain\n",
                    a.candidate.link, where, p.x() + 0.0, p.y() + 0.0, p.z() + 0.0, rpy(a.candidate.normal), a.gain);
    for (std::size_t j = 0; j < values.size() && j < 8; ++j) {
      const Freedom& f = r.over_views.freedoms[6 + j];
      text += fmt::format("    {}: {} instead of {}\n", f.name, amount(a.median_with[j], f.is_metres),
                          f.share_observed > 0 ? amount(f.median, f.is_metres) : "nothing");
    }
  }
  return text;
}

}  // namespace

std::string to_text(const Report& r) {
  if (r.sizes.empty()) return head_text(r) + "\nNo marks: nothing will be observed.\n";
  return head_text(r) + sizes_text(r) + freedoms_text(r) + losses_text(r) + symmetries_text(r) + advice_text(r);
}

}  // namespace articam::report
