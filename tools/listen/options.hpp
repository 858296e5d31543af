#pragma once
/// @file  What the user asks of articam-listen.

#include <cstdint>
#include <optional>
#include <string>

#include "hal/wire/address.hpp"

namespace articam::listen {

inline constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2;  ///< exit codes

struct Options {
  wire::Address from;  ///< host 0.0.0.0: every interface
  std::string key, key_state;
  std::string csv, mcap;  ///< files; empty: none
  bool csv_from_first{};  ///< t_s counts from the first estimate
  bool overwrite{};
  std::optional<wire::Address> json;
  bool quiet{}, stats{};
  std::uint64_t count{};  ///< 0: without end, as the two below
  double seconds{};
  double timeout_s{};
};

/// The exit code when the program has nothing more to do: help and version are printed, wrong usage is told.
std::optional<int> parse_options(int argc, const char* const* argv, Options& out);

}  // namespace articam::listen
