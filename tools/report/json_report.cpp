#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/report/report.hpp"

namespace articam::report {
namespace {

using Json = nlohmann::ordered_json;

/// JSON knows no infinity: null where nothing is known.
Json finite(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json numbers(const VectorX& v) {
  Json list = Json::array();
  for (const double x : v) list.push_back(finite(x));
  return list;
}

Json to_json(const View& view) {
  return {{"range_m", view.range_m},
          {"tilt_deg", view.tilt_deg},
          {"from", numbers(view.from)},
          {"joints", numbers(view.joints)}};
}

Json conditions_json(const Conditions& c) {
  return {{"width_px", c.camera.width_px},  {"height_px", c.camera.height_px}, {"fx_px", c.camera.fx_px},
          {"fy_px", c.camera.fy_px},        {"min_range_m", c.min_range_m},    {"max_range_m", c.max_range_m},
          {"max_tilt_deg", c.max_tilt_deg}, {"noise_px", c.noise_px}};
}

Json freedoms_json(const Report& r) {
  Json list = Json::array();
  const auto& all = r.over_views.freedoms;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Freedom& f = all[i];
    Json one{{"name", f.name},
             {"unit", f.is_metres ? "m" : "rad"},
             {"share_observed", f.share_observed},
             {"share_weak", f.share_weak},
             {"median_deviation", finite(f.median)},
             {"worst_deviation", finite(f.worst)},
             {"worst_dilution", f.worst_dilution}};
    if (f.share_observed > 0) one["worst_view"] = to_json(r.views[f.worst_view]);
    if (r.at_start) {
      const auto at = static_cast<Eigen::Index>(i);
      one["at_q0"] = {{"observed", bool{r.at_start->observed[i]}},
                      {"deviation", finite(r.at_start->deviation[at])},
                      {"dilution", finite(r.at_start->dilution[at])}};
    }
    list.push_back(one);
  }
  return list;
}

Json loss_json(const Loss& loss) {
  Json blinded = Json::array();
  for (const Blinded& b : loss.blinded) {
    blinded.push_back({{"name", b.name}, {"views_with", b.num_with}, {"views_without", b.num_without}});
  }
  return {{"observed_less", blinded},
          {"not_observed_at_q0", loss.at_start},
          {"grows_most", loss.worst_grown},
          {"growth", loss.growth},
          {"least_singular_px", loss.least_singular_px}};
}

Json marks_json(const Report& r) {
  Json list = Json::array();
  for (std::size_t i = 0; i < r.sizes.size(); ++i) {
    const Size& s = r.sizes[i];
    const Loss& loss = r.over_views.losses[i];
    list.push_back({{"name", s.marker},
                    {"nearest_px", s.nearest_px},
                    {"farthest_px", s.farthest_px},
                    {"max_range_m", s.max_range_m},
                    {"share_seen", loss.share_seen},
                    {"share_outside_picture", loss.share_outside_picture},
                    {"share_turned_away", loss.share_turned_away},
                    {"share_too_small", loss.share_too_small},
                    {"without_it", loss_json(loss)}});
  }
  return list;
}

Json symmetries_json(const Report& r) {
  Json list = Json::array();
  for (const Symmetry& s : r.symmetries) {
    list.push_back({{"takes_place_of", s.takes_place_of},
                    {"joints", numbers(s.joints)},
                    {"other_joints", numbers(s.other_joints)},
                    {"turn_rad", numbers(s.turn_rad)},
                    {"residual_m", s.residual_m}});
  }
  return list;
}

Json advice_json(const Report& r) {
  Json list = Json::array();
  for (const Advice& a : r.advice) {
    Json effects = Json::array();
    for (const Effect& e : a.effects) {
      effects.push_back({{"name", e.name},
                         {"share_observed_without", e.share_without},
                         {"share_observed_with", e.share_with},
                         {"median_deviation_without", finite(e.median_without)},
                         {"median_deviation_with", finite(e.median_with)}});
    }
    list.push_back({{"link", a.candidate.link},
                    {"poi", a.candidate.point},
                    {"place_m", numbers(a.candidate.place)},
                    {"normal", numbers(a.candidate.normal)},
                    {"diameter_m", a.candidate.mark.outer_diameter_m},
                    {"gain", a.gain},
                    {"effects", effects}});
  }
  return list;
}

}  // namespace

std::string to_json(const Report& r) {
  const std::size_t values = r.table.values().size();
  Json json{{"schema", 1},
            {"model", r.table.robot},
            {"links", r.num_links},
            {"joints",
             {{"all", r.num_joints},
              {"values", values},
              {"mimic", r.num_mimics},
              {"held", r.table.frozen.size()},
              {"fixed", r.num_fixed},
              {"left_out", r.num_left_out}}},
            {"narrowed", r.narrowed},
            {"conditions", conditions_json(r.conditions)},
            {"views", r.views.size()},
            {"share_complete", r.over_views.share_complete},
            {"median_singular_px", finite(r.over_views.median_singular_px)},
            {"least_singular_px", r.over_views.least_singular_px},
            {"degrees_of_freedom", freedoms_json(r)},
            {"marks", marks_json(r)},
            {"look_alikes", symmetries_json(r)},
            {"one_more_mark", advice_json(r)}};
  if (r.over_views.share_complete > 0) json["least_singular_view"] = to_json(r.views[r.over_views.least_singular_view]);
  if (r.at_start) json["singular_px_at_q0"] = r.start_singular_px;
  return json.dump(2) + '\n';
}

}  // namespace articam::report
