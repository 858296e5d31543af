// corpus_verdicts: the lines of verdicts.txt as this machine and this compiler have them.
#include <cstdio>

#include "tests/corpus/corpus.hpp"

int main() {
  std::puts(
      "# What becomes of every file of the URDF corpus: the hash of its header (with a point at each leaf link), and\n"
      "# that of every bit of its kinematics, double and float, at 20 random configurations. Held on every machine "
      "and\n"
      "# compiler. Written by: build/host-release/bin/corpus_verdicts >tests/corpus/verdicts.txt");
  for (const auto& file : articam::test::corpus()) std::puts(articam::test::verdict(file).c_str());
  return 0;
}
