#include <fmt/format.h>

#include "tests/corpus/corpus.hpp"

namespace articam::test {

std::string verdict(const CorpusFile& file) {
  if (file.evaluate == nullptr) return fmt::format("{}  refused: {}", file.name, file.refusal);
  return fmt::format("{}  header {:016x}  kinematics {:016x}", file.name, file.header_hash, hash_of(file.evaluate(1)));
}

}  // namespace articam::test
