#pragma once
/// @file  Where the board's estimates go: to the controller or to the terminal.

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "core/status.hpp"
#include "hal/app/board/board_options.hpp"
#include "hal/authentication/keyed_signer.hpp"
#include "hal/link/address_transport.hpp"
#include "hal/link/csv_row.hpp"
#include "hal/link/packet_link.hpp"
#include "hal/link/session.hpp"
#include "hal/posix/monotonic_clock.hpp"

namespace articam::app {

template <class Estimate>
class BoardLink;

template <class Model, class S>
class BoardLink<tracker::Estimate<Model, S>> {
 public:
  using Estimate = tracker::Estimate<Model, S>;

  /// Returns what went wrong, or nothing.
  std::string open(const BoardOptions& options, const CameraParameters& camera) {
    if (options.link == "stdout") {
      to_terminal_ = true;
      hal::put_csv_header<Model>(line_);
      return write_line() == Status::ok ? std::string{} : "standard output cannot be written";
    }
    errno = 0;
    if (carrier_.open(options.address) != Status::ok) {
      return "--link " + options.link + ": cannot be opened" +
             (errno != 0 ? std::string(": ") + std::strerror(errno) : "");
    }
    if (!options.key_file.empty()) {
      if (auto problem = open_signer(options); !problem.empty()) return problem;
    }
    packets_.emplace(carrier_, clock_, hal::ToMessage<Model>{camera, hal::draw_session(), options.rate_hz},
                     signer_ ? &*signer_ : nullptr);
    return {};
  }

  Status publish(const Estimate& estimate) noexcept {
    if (!to_terminal_) return packets_->publish(estimate);
    line_.clear();
    hal::put_csv_row(estimate, line_);
    return write_line();
  }

 private:
  std::string open_signer(const BoardOptions& options) {
    hal::Key key;
    std::string problem;
    if (key.load(options.key_file, problem) != Status::ok) return problem;
    signer_.emplace(key, options.counter_file);
    return signer_->open() == Status::ok ? std::string{} : signer_->problem();
  }

  Status write_line() noexcept {
    line_.put("\n");
    const auto text = line_.text();
    const bool whole = ::write(STDOUT_FILENO, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    return whole && !line_.overflowed() ? Status::ok : Status::io_error;
  }

  const hal::MonotonicClock clock_{};
  hal::AddressTransport carrier_;
  std::optional<hal::KeyedSigner> signer_;
  std::optional<hal::PacketLink<Estimate, hal::AddressTransport, hal::MonotonicClock>> packets_;
  bool to_terminal_{false};
  hal::CsvLine<Model> line_;
};

}  // namespace articam::app
