#include <csignal>

#include "hal/app/board/board_job.hpp"

namespace articam::app {

volatile std::sig_atomic_t g_stop_asked = 0;

void stop_on_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { g_stop_asked = 1; };
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) ::sigaction(signal, &action, nullptr);
  ::signal(SIGPIPE, SIG_IGN);  // a reader of standard output that goes is a link that fails, not the end
}

void warn(const std::string& program, const std::string& text) {
  fmt::print(stderr, "{}: warning: {}\n", program, text);
}

}  // namespace articam::app
