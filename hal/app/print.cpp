#include "hal/app/print.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace articam::app {

std::string print(const std::string& text) {
  const bool printed = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  return printed ? std::string{} : std::string("standard output: ") + std::strerror(errno);
}

}  // namespace articam::app
