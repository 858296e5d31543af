#pragma once
/// @file  What `articam-replay --identify` does around its replay: read the sources before, write the files after.

#include <optional>
#include <string>
#include <vector>

#include "tools/identify/identify.hpp"
#include "tools/modelgen/compile_model.hpp"
#include "tools/modelgen/read_markers.hpp"

namespace articam::identify {

struct JobOptions {
  std::vector<std::string> outputs;  ///< each FILE.urdf, FILE.yaml or FILE.yml
  std::vector<std::string> still;    ///< joints; empty: those that stand still in the recording
  std::string urdf, markers;         ///< what the model was compiled from
  std::string camera_file;           ///< for messages
};

/// Empty, or what is wrong with the usage.
std::string why_wrong(const JobOptions& options, const Object& object);

class Job {
 public:
  /// Reads the sources. Errors  what modelgen says of them; or that the object was not compiled from them.
  static std::optional<Job> prepare(const JobOptions& options, Object object, modelgen::Diagnostics& diagnostics);

  /// Writes all files, or none; `text` is then what a person should read. Returns what went wrong, or nothing.
  std::string finish(const Recording& recording, const CameraParameters& camera, std::string& text) const;

 private:
  Job(JobOptions options, Object object) : options_{std::move(options)}, object_{std::move(object)} {}

  Request request(const Recording& recording) const;
  std::optional<std::vector<double>> shortened_q0(const Findings& findings) const;
  std::string write(const Findings& findings, std::string& text) const;

  JobOptions options_;
  Object object_;
  modelgen::SourceFile urdf_;
  modelgen::MarkersFile markers_;
  modelgen::UrdfModel model_;
  std::vector<Mat3> R_body_link_;  ///< of each marker's frame
};

}  // namespace articam::identify
