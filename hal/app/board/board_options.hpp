#pragma once
/// @file  What a user may choose when the board's program starts.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "core/tracker/options.hpp"
#include "hal/capture/exposure_stamp.hpp"
#include "hal/wire/address.hpp"

namespace articam::app {

struct BoardOptions {
  enum class Source : std::uint8_t { libcamera, v4l2, replay };

  Source source{Source::libcamera};
  std::string device;  ///< id of libcamera's camera (empty: the first), device file, or folder of frames
  double rate_hz{30};
  std::optional<double> exposure_us, gain;  ///< none: automatic
  std::optional<hal::StampMarks> stamp;     ///< what libcamera's time stamp marks; none: as the camera tells
  std::uint64_t num_frames{};               ///< then stop; 0: never

  std::string link{wire::kDefaultAddress};  ///< or "stdout"
  wire::Address address;                    ///< the same, parsed
  std::string key_file, counter_file;       ///< of authentication; empty: none

  int priority{50};        ///< SCHED_FIFO; 0: none
  std::optional<int> cpu;  ///< none: any
  bool quiet{};            ///< no statistics

  std::string q0;  ///< empty: the model's own
  tracker::Mode mode{tracker::Mode::standard};

  std::string record, record_frames;  ///< empty: not recorded
  std::uint64_t record_mb{64};
  double record_seconds{5};
};

/// What the program is, for --help and --version.
struct BoardTitle {
  std::string name, model, camera, version;
};

/// The options, or an exit code: 0 after --help and --version, 2 after wrong usage; what there is to say has been said.
std::variant<BoardOptions, int> read_board_options(const BoardTitle& title, int argc, char** argv);

}  // namespace articam::app
