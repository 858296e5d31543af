#pragma once
/// @file  main() of a board's program: options, the camera that they name, the job.

#include <memory>

#include "hal/app/board/board_cameras.hpp"
#include "hal/app/board/board_job.hpp"

namespace articam::app {

/// The exit code: 0 stopped, 1 no camera or the job failed, 2 wrong usage.
template <class Model>
int run_board(const BoardTitle& title, const CameraParameters& camera, int argc, char** argv) {
  const auto chosen = read_board_options(title, argc, argv);
  if (const int* const exit_code = std::get_if<int>(&chosen)) return *exit_code;
  const BoardOptions& options = std::get<BoardOptions>(chosen);
  stop_on_signals();
  const auto job = std::make_unique<BoardJob<Model>>(title, options, camera);  // large: it holds the detector's images
  const std::string problem = with_camera(options, camera, [&](auto& port) { return job->run(port); });
  if (problem.empty()) return 0;
  fmt::print(stderr, "{}: {}\n", title.name, problem);
  return 1;
}

}  // namespace articam::app
