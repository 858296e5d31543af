// A libFuzzer target: any bytes as a URDF, and behind a line "---" as a markers file. What must hold is said by LAW.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "tools/modelgen/compile_model.hpp"
#include "tools/report/report.hpp"

namespace {

using namespace articam::modelgen;

void law(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken law: %s\n", what);
  std::abort();  // libFuzzer keeps the input
}

/// Nothing where the bytes are refused before anything is read of them.
std::optional<CompileJob> job_of(std::string_view text, Diagnostics& diagnostics) {
  constexpr std::string_view kFence = "\n---\n";
  const auto fence = text.find(kFence);
  const auto urdf = make_source({"m.urdf", std::string(text.substr(0, fence))}, diagnostics);
  if (!urdf) return std::nullopt;
  CompileJob job{*urdf, {}, "Model", {}};
  if (fence == text.npos) return job;
  job.markers = make_source({"m.yaml", std::string(text.substr(fence + kFence.size()))}, diagnostics);
  return job.markers ? std::optional{job} : std::nullopt;
}

bool is_one_line_of_text(std::string_view text) {
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return false;
  }
  return true;
}

/// Comments end with their line, and literals hold no quote of their own: no name can leave either.
void check_header(const std::string& header) {
  for (std::size_t begin = 0; begin < header.size();) {
    const std::size_t end = header.find('\n', begin);
    law(end != header.npos, "the header ends with a line");
    const std::string_view line = std::string_view(header).substr(begin, end - begin);
    law(is_one_line_of_text(line), "the header is text");
    law(!line.ends_with('\\'), "no line of the header goes on in the next");
    std::size_t quotes = 0;
    for (std::size_t i = 0; i < line.size() && !line.starts_with("//"); ++i) {
      if (line[i] == '\\') {
        ++i;
      } else if (line[i] == '"') {
        ++quotes;
      }
    }
    law(quotes % 2 == 0, "every literal ends on its line");
    begin = end + 1;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Diagnostics first, second;
  const auto job = job_of({reinterpret_cast<const char*>(data), size}, first);
  const auto model = job ? compile_model(*job, first) : std::nullopt;
  law(model.has_value() != first.has_errors(), "a model, or an error that says why there is none");
  for (const Message& message : first.messages()) {
    law(is_one_line_of_text(to_string(message)), "a message is one line that cannot steer a terminal");
  }
  if (!model) return 0;
  check_header(model->header);
  law(compile_model(*job, second)->header == model->header, "two runs give the same bytes");
  if (size % 16 == 0 && model->table.joints.size() < 4 && model->table.markers.size() < 5) {
    articam::report::Conditions conditions;
    conditions.camera = articam::report::default_camera();
    conditions.max_tilt_deg = 0;  // few views: it is about what the numbers are, not about how many
    const auto report = articam::report::make_report(*model, conditions);
    law(!to_text(report).empty() && !to_json(report).empty(), "every model has its report");
  }
  return 0;
}
