#pragma once
/// @file  What a controller needs of a board: the newest estimate, predicted to now, without ever waiting for it.

#include <cstdint>
#include <memory>
#include <string>

#include "core/status.hpp"
#include "core/timestamp.hpp"
#include "hal/receiver/counters.hpp"
#include "hal/receiver/health.hpp"
#include "hal/wire/address.hpp"
#include "hal/wire/authentication.hpp"
#include "hal/wire/message.hpp"

namespace articam::receiver {

struct Options {
  std::string address{wire::kDefaultAddress};  ///< UDP or serial line, see hal/wire/address.hpp
  std::uint64_t model_hash{};                  ///< articam::model::table_hash of the model; 0 takes every one
  double horizon_s{0.1};                       ///< an estimate is predicted this far, and not farther
  wire::Verifier* verifier{};                  ///< authentication, off by default; outlives the receiver
};

enum class Freshness : std::uint8_t {
  nothing,  ///< no estimate has come yet
  fresh,    ///< predicted to now
  stale,    ///< older than the horizon: predicted to its end only, no longer to be followed
};

struct Reading {
  Freshness freshness{Freshness::nothing};
  double age_s{};      ///< from the capture until now
  double silence_s{};  ///< since the packet came to this machine
  wire::EstimateMessage estimate{};

  /// A pose and joints to act on. Whether `tracking` is asked for, or `degraded` will do, is the controller's choice.
  bool usable() const noexcept { return freshness == Freshness::fresh && estimate.valid; }
};

/// Hears one board from a thread of its own. That one runs under SCHED_OTHER, whatever the creator runs under, and
/// takes no signals.
///
/// Age   The clocks of two machines are never compared. An estimate's age is what the board says that it took from
///       the capture to the sending, by the board's clock, and what has passed since the receipt, by ours. The time
///       on the network is in neither; on a local one it is well below a millisecond.
class Receiver {
 public:
  Receiver();
  ~Receiver();
  Receiver(const Receiver&) = delete;
  Receiver& operator=(const Receiver&) = delete;

  /// Opens the socket or the line and starts the thread. May allocate.
  /// Errors  bad_argument, io_error; problem() is then a sentence.
  Status start(const Options& options);
  void stop() noexcept;
  const std::string& problem() const noexcept { return problem_; }

  /// Wait-free and without heap; for one thread. Every number in it is finite.
  Reading newest(Timestamp now = Receiver::now()) noexcept;
  /// The names of the numbers, as the board sends them once a second; false before the first. For the same thread.
  /// In the first second after a restart of the board they are those of its session before: compare `session`.
  bool model(wire::ModelMessage& out) noexcept;
  /// As they were after the last wake-up. For the same thread.
  Counters counters() noexcept;

  /// For the same thread.
  Health health() noexcept;

  /// CLOCK_MONOTONIC of this machine.
  static Timestamp now() noexcept;

 private:
  struct Hearing;
  std::unique_ptr<Hearing> hearing_;
  double horizon_s_{};
  std::string problem_;
};

}  // namespace articam::receiver
