#pragma once
/// @file  Every URDF of the corpus as what our compiler made of it.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "tests/corpus/evaluate.hpp"

namespace articam::test {

struct CorpusFile {
  const char* name{};                           ///< without its folder
  const char* refusal{};                        ///< the first error; empty where a header was made
  std::uint64_t header_hash{};                  ///< of its text
  Evaluated (*evaluate)(std::uint64_t seed){};  ///< the compiled header's kinematics; null where refused
};

/// In the order of their names.
std::span<const CorpusFile> corpus();

/// `NAME  header HASH  kinematics HASH`, or `NAME  refused: REASON`: the same on every machine.
std::string verdict(const CorpusFile& file);

}  // namespace articam::test
