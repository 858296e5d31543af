#include "tools/listen/outputs.hpp"

#include <cstdio>

namespace articam::listen {
namespace {

bool complain(const std::string& problem) {
  if (!problem.empty()) std::fputs(("articam-listen: " + problem + '\n').c_str(), stderr);
  return !problem.empty();
}

}  // namespace

void Outputs::take(const Heard& heard) {
  ++taken_;
  const auto fails = [&](const std::unique_ptr<Output>& output) { return complain(output->take(heard)); };
  if (std::erase_if(outputs_, fails) > 0) failed_ = true;
}

void Outputs::finish() {
  for (const auto& output : outputs_) failed_ = complain(output->finish()) || failed_;
  outputs_.clear();
}

}  // namespace articam::listen
