#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

#include "tests/corpus/corpus.hpp"

namespace articam::test {
namespace {

/// The committed verdicts by file.
std::map<std::string, std::string> expected() {
  std::ifstream file(ARTICAM_CORPUS_VERDICTS);
  std::map<std::string, std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with('#')) lines[line.substr(0, line.find(' '))] = line;
  }
  return lines;
}

TEST(Corpus, HeadersAndTheirKinematicsAreTheSameBitsOnEveryMachine) {
  const auto verdicts = expected();
  for (const CorpusFile& file : corpus()) {
    const auto found = verdicts.find(file.name);
    EXPECT_EQ(found == verdicts.end() ? "" : found->second, verdict(file));
  }
  EXPECT_EQ(corpus().size(), verdicts.size());
}

TEST(Corpus, EveryRefusalHasAReason) {
  for (const CorpusFile& file : corpus()) {
    EXPECT_NE(file.evaluate == nullptr, std::string(file.refusal).empty()) << file.name;
  }
}

}  // namespace
}  // namespace articam::test
