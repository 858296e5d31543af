#include "tools/listen/csv_output.hpp"

#include <charconv>
#include <cstddef>
#include <system_error>

#include "tools/listen/clock_map.hpp"
#include "tools/listen/covariance.hpp"

namespace articam::listen {
namespace {

/// The shortest text that reads back as the same number.
template <class Number>
void put(std::string& row, Number x) {
  char text[32];
  const auto [end, error] = std::to_chars(std::begin(text), std::end(text), x);
  row.append(text, error == std::errc{} ? end : text);
}

}  // namespace

std::string csv_header(const wire::ModelMessage& model) {
  std::string header = "frame,t_s,status,reason,px,py,pz,qw,qx,qy,qz";
  for (const wire::Text& joint : model.joint_names) header.append(",").append(wire::view(joint));
  header += ",std_px,std_py,std_pz,std_rx,std_ry,std_rz";
  for (const wire::Text& joint : model.joint_names) header.append(",std_").append(wire::view(joint));
  return header + ",matched,rms_px";
}

std::string csv_row(const wire::EstimateMessage& estimate, std::size_t num_joints, Timestamp t_zero) {
  std::string row;
  const auto field = [&](auto x) { row += ',', put(row, x); };
  put(row, estimate.frame);
  field(static_cast<double>(ClockMap::minus(estimate.t_capture.ns, t_zero.ns)) / 1e9);
  row.append(",").append(name(estimate.status)).append(",").append(name(estimate.reason));
  if (estimate.valid) {
    for (const double x : estimate.t_cam_obj) field(x);
    for (const double x : estimate.joints) field(x);
    for (std::size_t i = 0; i < dof(estimate); ++i) field(deviation(estimate, i));
  } else {
    row.append(7 + num_joints + 6 + num_joints, ',');
  }
  field(estimate.matched);
  if (estimate.matched > 0) {
    field(estimate.rms_px);
  } else {
    row += ',';
  }
  return row;
}

std::string CsvOutput::take(const Heard& heard) {
  const std::string header = csv_header(heard.model);
  if (header_.empty()) {
    header_ = header;
    if (const std::string problem = file_->append(header + '\n'); !problem.empty()) return problem;
  }
  if (header != header_) return "CSV: the board now runs a model with other joints: record it in a file of its own";
  const Timestamp t_zero = relative_ ? heard.t_first : Timestamp{};
  return file_->append(csv_row(heard.estimate, heard.model.joint_names.size(), t_zero) + '\n');
}

}  // namespace articam::listen
