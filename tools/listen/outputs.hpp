#pragma once
/// @file  All outputs that were asked for.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tools/listen/output.hpp"

namespace articam::listen {

/// One that fails is told on standard error and left; the others go on.
class Outputs {
 public:
  void add(std::unique_ptr<Output> output) { outputs_.push_back(std::move(output)); }

  void take(const Heard& heard);
  void finish();

  std::uint64_t taken() const { return taken_; }
  bool failed() const { return failed_; }                          ///< at least one
  bool all_failed() const { return failed_ && outputs_.empty(); }  ///< nothing is left to do

 private:
  std::vector<std::unique_ptr<Output>> outputs_;
  std::uint64_t taken_{};
  bool failed_{};
};

}  // namespace articam::listen
