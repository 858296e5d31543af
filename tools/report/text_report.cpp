#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tools/report/report.hpp"

namespace articam::report {
namespace {

/// A deviation for people: mm or deg, three digits.
std::string amount(double deviation, bool is_metres) {
  if (!std::isfinite(deviation)) return "-";
  return is_metres ? fmt::format("{:.3g} mm", 1e3 * deviation) : fmt::format("{:.3g} deg", deviation / kDegree);
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

std::string narrowed_text(const Report& r) {
  std::string text;
  for (const std::string& joint : r.narrowed) text += "  " + joint + '\n';
  return text;
}

std::string head_text(const Report& r) {
  const Conditions& c = r.conditions;
  const std::size_t values = r.table.values().size();
  return fmt::format(
             "{}: what its marks will tell\n"
             "\n"
             "Camera {}x{}, focal length {:.0f} px. Range {:.2f} to {:.2f} m, tilt up to {:.0f} deg.\n"
             "Noise {:g} px on each coordinate of a mark's centre. Every deviation is the Cramer-Rao bound of the "
             "centres "
             "alone,\n"
             "without distortion: no estimator without bias does better. Marks hide behind nothing here.\n"
             "\n"
             "Model\n"
             "  {} links, {} joints: {} with a value of their own, {} that mimic, {} held, {} fixed, {} left out (no "
             "mark "
             "moves)\n"
             "  {} marks, {} degrees of freedom: 6 of the base, {} of joints\n",
             r.table.robot, c.camera.width_px, c.camera.height_px, c.camera.fx_px, c.min_range_m, c.max_range_m,
             c.max_tilt_deg, c.noise_px, r.num_links, r.num_joints, values, r.num_mimics, r.table.frozen.size(),
             r.num_fixed, r.num_left_out, r.sizes.size(), 6 + values, values) +
         narrowed_text(r);
}

std::string sizes_text(const Report& r) {
  std::vector<std::vector<std::string>> rows{{"mark", fmt::format("at {:.2f} m", r.conditions.min_range_m),
                                              fmt::format("at {:.2f} m", r.conditions.max_range_m),
                                              fmt::format("{:.0f} px up to", kMinDiameter_px), "seen",
                                              "off the picture", "turned away", "too small", ""}};
  for (std::size_t i = 0; i < r.sizes.size(); ++i) {
    const Size& s = r.sizes[i];
    const Loss& l = r.over_views.losses[i];
    const bool small = s.farthest_px < kMinDiameter_px;
    rows.push_back({s.marker, fmt::format("{:.0f} px", s.nearest_px), fmt::format("{:.0f} px", s.farthest_px),
                    fmt::format("{:.2f} m", s.max_range_m), percent(l.share_seen), percent(l.share_outside_picture),
                    percent(l.share_turned_away), percent(l.share_too_small), small ? "TOO SMALL for the range" : ""});
  }
  return fmt::format("\nMarks: how large they appear, face to face, and what becomes of them in {} views\n",
                     r.views.size()) +
         table_text(rows);
}

/// A warning where a number is never known, or a joint far worse than its marks could tell.
std::string verdict(const Freedom& f, bool is_joint) {
  if (f.share_observed == 0) return "in NONE of these views";
  return is_joint && f.worst_dilution > kWeakDilution ? "WEAK in " + percent(f.share_weak) : "";
}

std::string start_text(const Report& r, std::size_t i) {
  if (!r.at_start) return "-";
  if (!r.at_start->observed[i]) return "NOT OBSERVED";
  const auto at = static_cast<Eigen::Index>(i);
  const bool weak = i >= 6 && r.at_start->dilution[at] > kWeakDilution;
  return amount(r.at_start->deviation[at], r.over_views.freedoms[i].is_metres) + (weak ? " WEAK" : "");
}

std::string worst_views_text(const Report& r) {
  std::string text;
  const auto& all = r.over_views.freedoms;
  for (std::size_t i = 6; i < all.size(); ++i) {
    if (!(all[i].worst_dilution > kWeakDilution)) continue;
    text += fmt::format(
        "  {} is worst at {}:\n    {:.0f} times less certain than its marks could tell across the line of sight\n",
        all[i].name, describe(r.views[all[i].worst_view], r.table, i - 6), all[i].worst_dilution);
  }
  return text;
}

std::string singular_text(const Report& r) {
  const Observability& o = r.over_views;
  std::string text = fmt::format(
      "  Everything is observed in {} of the views. Least singular value, px a step of 1 cm or 1 deg: median {:.3g}",
      percent(o.share_complete), o.median_singular_px);
  if (r.at_start) text += fmt::format(", at q0 {:.3g}", r.start_singular_px);
  if (o.share_complete == 0) return text + "\n";
  return text + fmt::format(",\n    least of those views {:.3g} at {}\n", o.least_singular_px,
                            describe(r.views[o.least_singular_view], r.table));
}

std::string freedoms_text(const Report& r) {
  std::vector<std::vector<std::string>> rows{{"", "observed", "median", "worst", "at q0", ""}};
  const auto& all = r.over_views.freedoms;
  for (std::size_t i = 0; i < all.size(); ++i) {
    rows.push_back({all[i].name, percent(all[i].share_observed), amount(all[i].median, all[i].is_metres),
                    amount(all[i].worst, all[i].is_metres), start_text(r, i), verdict(all[i], i >= 6)});
  }
  return "\nDegrees of freedom: share of the views that observe them, standard deviation there\n"
         "(tx ty tz rx ry rz: the base in the camera's frame, rotation vector)\n" +
         table_text(rows) + worst_views_text(r) + singular_text(r);
}

/// What fewer views observe without a mark, joints first.
std::string blinded_text(const Loss& loss) {
  constexpr std::size_t kMost = 4;
  std::vector<Blinded> blinded = loss.blinded;
  std::stable_partition(blinded.begin(), blinded.end(), [](const Blinded& b) { return !b.is_of_base; });
  std::string text;
  for (std::size_t k = 0; k < std::min(blinded.size(), kMost); ++k) {
    const Blinded& b = blinded[k];
    text += k == 0 ? "" : ", ";
    text += b.num_without == 0 ? b.name + " NOT OBSERVED"
                               : fmt::format("{} in {} of {} views", b.name, b.num_without, b.num_with);
  }
  return blinded.size() > kMost ? fmt::format("{} and {} more", text, blinded.size() - kMost) : text;
}

std::string losses_text(const Report& r) {
  std::string text = "\nWithout one mark, in the views that see it\n";
  for (const Loss& loss : r.over_views.losses) {
    text += fmt::format("  {}: ", loss.marker);
    if (loss.share_seen == 0) {
      text += "seen in none of the views\n";
      continue;
    }
    text += loss.blinded.empty() ? "nothing is lost" : "less is observed";
    if (loss.growth > 1.005) text += fmt::format("; {} {:.2f} times less certain", loss.worst_grown, loss.growth);
    text += fmt::format("; least singular value {:.3g} px\n", loss.least_singular_px);
    if (!loss.blinded.empty()) text += fmt::format("    {}\n", blinded_text(loss));
    if (!loss.at_start.empty()) text += fmt::format("    NOT OBSERVED at q0: {}\n", fmt::join(loss.at_start, " "));
  }
  return text;
}

std::string three(const Vec3& v, double unit, int digits) {
  const Vec3 w = v.unaryExpr([=](double x) { return std::round(x / unit) * unit + 0.0; });  // no -0
  return fmt::format("{:.{}f} {:.{}f} {:.{}f}", w.x(), digits, w.y(), digits, w.z(), digits);
}

std::string turn_text(const Symmetry& s) {
  const double turn_deg = s.turn_rad.norm() / kDegree;
  if (turn_deg < 0.1) return "the base where it is";
  return fmt::format("the base turned by {:.0f} deg about ({})", turn_deg, three(s.turn_rad.normalized(), 0.01, 2));
}

/// Which mark lies on which other.
std::string exchange_text(const Symmetry& s, const modelgen::Table& table) {
  constexpr std::size_t kMost = 4;
  std::vector<std::string> pairs;
  for (std::size_t m = 0; m < s.takes_place_of.size(); ++m) {
    if (s.takes_place_of[m] == m) continue;
    pairs.push_back(fmt::format("{}->{}", table.markers[m].name, table.markers[s.takes_place_of[m]].name));
  }
  const std::size_t shown = std::min(pairs.size(), kMost);
  const std::string more = pairs.size() > kMost ? fmt::format(" and {} more", pairs.size() - kMost) : "";
  const auto end = pairs.begin() + static_cast<std::ptrdiff_t>(shown);
  return fmt::format("    marks change places: {}{}\n", fmt::join(pairs.begin(), end, " "), more);
}

std::string symmetries_text(const Report& r) {
  std::string text = "\nLook-alikes: other configurations that put marks of the same kind and size where these are\n";
  if (r.symmetries.empty()) return text + "  none found (searched, not proven)\n";
  for (const Symmetry& s : r.symmetries) {
    const std::string at = describe_joints(s.joints, r.table), other = describe_joints(s.other_joints, r.table);
    const double nearest_px = s.residual_m * r.conditions.camera.fx_px / r.conditions.min_range_m;
    text += fmt::format("  {}: {}, {:.1f} mm or {:.1f} px off at {:.2f} m\n",
                        nearest_px < 1 ? "AMBIGUOUS" : "NEARLY AMBIGUOUS", turn_text(s), 1e3 * s.residual_m, nearest_px,
                        r.conditions.min_range_m);
    if (!at.empty()) text += fmt::format("    at {}\n    as {}\n", at, other);
    if (!s.needs_identities()) {
      text += "    even if marks carried identities\n";
      continue;
    }
    text += exchange_text(s, r.table);
  }
  if (r.symmetries.size() >= kMaxSymmetries) text += "  There may be more: the search stops here.\n";
  return text + "  A q0 in the markers file decides which is meant; better, move a mark, or give one another size.\n";
}

/// The angles that turn +z to the normal.
std::string rpy(const Vec3& normal) {
  const double roll = -std::asin(std::clamp(normal.y(), -1.0, 1.0)), pitch = std::atan2(normal.x(), normal.z());
  return three(Vec3(roll, pitch, 0), 1e-6, 6);
}

std::string kind_text(const modelgen::TableMarker& mark) {
  const double diameter_mm = 1e3 * mark.outer_diameter_m;
  if (mark.kind == model::MarkerKind::ring) return fmt::format("ring of {:.3g} mm", diameter_mm);
  return fmt::format("{} dot of {:.3g} mm", mark.kind == model::MarkerKind::dot_light_on_dark ? "light" : "dark",
                     diameter_mm);
}

std::string effect_text(const Effect& e) {
  std::string text = fmt::format("    {}: ", e.name);
  if (e.share_with > e.share_without + 1e-9) {
    text += fmt::format("observed in {} instead of {} of the views", percent(e.share_with), percent(e.share_without));
    if (std::isfinite(e.median_with)) text += ", ";
  }
  if (!std::isfinite(e.median_with)) return text + '\n';
  return text + fmt::format("median {} instead of {}\n", amount(e.median_with, e.is_metres),
                            amount(e.median_without, e.is_metres));
}

std::string advice_text(const Report& r) {
  constexpr std::size_t kMost = 8;
  std::string text = "\nOne more mark, where it would help most (see yourself whether the object is there)\n";
  for (const Advice& a : r.advice) {
    const std::string where = a.candidate.point.empty() ? "" : fmt::format(" (--poi {})", a.candidate.point);
    text += fmt::format("  a {} on link {}{}: <origin xyz=\"{}\" rpy=\"{}\"/>\n", kind_text(a.candidate.mark),
                        a.candidate.link, where, three(a.candidate.place, 0.001, 3), rpy(a.candidate.normal));
    for (std::size_t j = 0; j < std::min(a.effects.size(), kMost); ++j) text += effect_text(a.effects[j]);
    if (a.effects.size() > kMost)
      text += fmt::format("    and {} more, see the report as JSON\n", a.effects.size() - kMost);
  }
  if (r.advice.empty()) text += "  no place is free\n";
  return text;
}

}  // namespace

std::string to_text(const Report& r) {
  if (r.sizes.empty()) return head_text(r) + "\nNo marks: nothing will be observed.\n";
  return head_text(r) + sizes_text(r) + freedoms_text(r) + losses_text(r) + symmetries_text(r) + advice_text(r);
}

}  // namespace articam::report
