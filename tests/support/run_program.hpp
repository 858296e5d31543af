#pragma once
/// @file  A program run from outside, as a user would.

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace articam::test {

struct Ended {
  int exit_code{};
  std::string text;  ///< stdout and stderr
};

/// Runs a shell command; exit_code is -1 when it ended by a signal.
inline Ended run(const std::string& command) {
  std::FILE* const pipe = ::popen(("{ " + command + "; } 2>&1").c_str(), "r");
  Ended ended;
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) ended.text.append(buffer.data(), n);
  const int status = ::pclose(pipe);
  ended.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

}  // namespace articam::test
