#pragma once
/// @file  Decides which packets count: knows nothing of sockets and threads.

#include <cstdint>
#include <span>

#include "core/timestamp.hpp"
#include "hal/receiver/counters.hpp"
#include "hal/wire/authentication.hpp"
#include "hal/wire/message.hpp"

namespace articam::receiver {

class Intake {
 public:
  enum class Taken : std::uint8_t { nothing, estimate, model };

  /// `model_hash`: 0 takes every model. `verifier`: null takes every packet, tagged or not.
  explicit Intake(std::uint64_t model_hash = 0, wire::Verifier* verifier = nullptr) noexcept
      : model_hash_{model_hash}, verifier_{verifier} {}

  /// Says what of message() is new. A packet that is refused changes nothing but the counters. Once an estimate has
  /// come, only a model of its session is new: after a restart of the board, the one that comes a second later.
  Taken take(std::span<const std::uint8_t> packet, Timestamp t_receipt) noexcept;

  const wire::Message& message() const noexcept { return message_; }
  const Counters& counters() const noexcept { return counters_; }

 private:
  wire::Fault open(std::span<const std::uint8_t> packet) noexcept;
  bool is_newest(const wire::EstimateMessage& estimate, Timestamp t_receipt) noexcept;
  void begin_session(const wire::EstimateMessage& estimate) noexcept;

  std::uint64_t model_hash_;
  wire::Verifier* verifier_;
  wire::Message message_{};
  Counters counters_{};
  bool any_{false};
  std::uint64_t session_{}, session_before_{};
  Timestamp t_heard_{};     ///< of the session
  std::uint32_t newest_{};  ///< number in the session
  std::uint64_t came_{};    ///< bit i: number newest_ - i has come
};

}  // namespace articam::receiver
