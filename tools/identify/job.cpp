#include "tools/identify/job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "tools/identify/compare_sources.hpp"
#include "tools/identify/freeze_joints.hpp"
#include "tools/identify/markers_text.hpp"
#include "tools/identify/report.hpp"
#include "tools/modelgen/output_files.hpp"

namespace articam::identify {
namespace {

using modelgen::Diagnostics;

bool is_urdf(const std::string& output) { return output.ends_with(".urdf"); }
bool is_yaml(const std::string& output) { return output.ends_with(".yaml") || output.ends_with(".yml"); }

bool any_yaml(const JobOptions& options) { return std::ranges::any_of(options.outputs, is_yaml); }
bool any_urdf(const JobOptions& options) { return std::ranges::any_of(options.outputs, is_urdf); }

std::vector<std::string> value_names(const Object& object) {
  std::vector<std::string> names;
  for (const model::JointRow& row : object.values()) names.emplace_back(row.name);
  return names;
}

/// What has to be so before files are written.
std::string why_not(const JobOptions& options, const Findings& findings) {
  if (!findings.converged) return "the adjustment did not converge: is this a recording of this model?";
  if (any_yaml(options) && findings.places.empty()) {
    return "this recording does not tell where the markers are: move the camera around the object, nearer and farther, "
           "and every joint over its range";
  }
  if (any_urdf(options) && findings.lengths.empty()) {
    return "every joint moved: there is no constant to identify; --virtual names one";
  }
  return {};
}

}  // namespace

std::string why_wrong(const JobOptions& options, const Object& object) {
  for (const std::string& output : options.outputs) {
    if (!is_urdf(output) && !is_yaml(output))
      return fmt::format("--identify {}: neither FILE.urdf nor FILE.yaml", output);
  }
  const std::vector<std::string> names = value_names(object);
  for (const std::string& joint : options.still) {
    if (std::ranges::count(names, joint) == 0)
      return fmt::format("--virtual {}: no such joint; there are: {}", joint, fmt::join(names, ", "));
  }
  return {};
}

std::optional<Job> Job::prepare(const JobOptions& options, Object object, Diagnostics& diagnostics) {
  Job job{options, std::move(object)};
  const auto urdf = modelgen::read_source(options.urdf, diagnostics);
  const auto markers = modelgen::read_source(options.markers, diagnostics);
  if (!urdf || !markers) return std::nullopt;
  const auto compiled = modelgen::compile_model({*urdf, *markers, "Identified", {}}, diagnostics);
  auto markers_file = modelgen::read_markers(*markers, diagnostics);
  if (!compiled || !markers_file) return std::nullopt;
  if (const std::string why = why_different(job.object_, compiled->table); !why.empty()) {
    diagnostics.error(options.urdf, 0, "model", why);
    return std::nullopt;
  }
  job.R_body_link_ = axes_of_frames({*urdf, *markers, "Identified", {}}, *markers_file);
  job.urdf_ = *urdf;
  job.markers_ = *std::move(markers_file);
  job.model_ = compiled->model;
  return job;
}

Request Job::request(const Recording& recording) const {
  const std::vector<std::string> names = value_names(object_);
  std::vector<bool> slides;
  for (const model::JointRow& row : object_.values()) slides.push_back(row.kind == model::JointKind::prismatic);
  Request request{find_still(recording, slides), any_yaml(options_)};
  if (options_.still.empty()) return request;
  request.still.clear();
  for (std::size_t j = 0; j < names.size(); ++j) {
    if (std::ranges::count(options_.still, names[j]) > 0) request.still.push_back(static_cast<int>(j));
  }
  return request;
}

std::optional<std::vector<double>> Job::shortened_q0(const Findings& findings) const {
  if (!markers_.q0) return std::nullopt;
  const bool frozen = any_urdf(options_);
  std::vector<double> q0{markers_.q0->begin(), markers_.q0->begin() + 7};
  for (std::size_t j = 0; j < object_.values().size(); ++j) {
    const auto found = std::ranges::find(findings.lengths, object_.values()[j].name, &Length::joint);
    if (found == findings.lengths.end()) {
      q0.push_back((*markers_.q0)[7 + j]);
    } else if (!frozen) {
      q0.push_back(found->value);
    }
  }
  return q0;
}

std::string Job::write(const Findings& findings, std::string& text) const {
  std::vector<modelgen::OutputFile> files;
  Diagnostics diagnostics;
  const auto q0 = shortened_q0(findings);
  for (const std::string& output : options_.outputs) {
    if (is_yaml(output)) {
      files.push_back({output, markers_text(markers_, findings.places, R_body_link_, q0)});
      continue;
    }
    const auto urdf = freeze_joints(urdf_, model_, findings.lengths, diagnostics);
    if (!urdf) return diagnostics.text();
    files.push_back({output, *urdf});
  }
  if (const std::string problem = modelgen::write_files(files); !problem.empty()) return problem;
  text += fmt::format("wrote {}\n", fmt::join(options_.outputs, " and "));
  if (any_urdf(options_) && !any_yaml(options_) && q0) {
    text += fmt::format("its markers file is {} with this start, which has no place for what is fixed now:\nq0: [{}]\n",
                        options_.markers, fmt::join(*q0, ", "));
  }
  return {};
}

std::string Job::finish(const Recording& recording, const CameraParameters& camera, std::string& text) const {
  const auto findings = identify(object_, camera, recording, request(recording));
  if (!findings) {
    return fmt::format("only {} frames have an estimate and enough markers; {} are the least to identify anything",
                       recording.size(), kLeastMoments);
  }
  text = to_text(*findings, options_.camera_file);
  if (const std::string problem = why_not(options_, *findings); !problem.empty()) return problem;
  return write(*findings, text);
}

}  // namespace articam::identify
