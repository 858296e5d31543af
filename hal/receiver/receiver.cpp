#include "hal/receiver/receiver.hpp"

#include <pthread.h>
#include <sched.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

#include "hal/posix/monotonic_clock.hpp"
#include "hal/posix/packet_inlet.hpp"
#include "hal/receiver/intake.hpp"
#include "hal/receiver/prediction.hpp"
#include "hal/receiver/take_packets.hpp"
#include "hal/receiver/triple_buffer.hpp"

namespace articam::receiver {
namespace {

constexpr std::chrono::milliseconds kLookUp{100};  // how soon stop() is noticed

struct Heard {
  bool any{};
  Timestamp t_receipt{};
  wire::EstimateMessage estimate{};
};

struct Names {
  bool any{};
  wire::ModelMessage model{};
};

/// A thread inherits what is blocked where it is made: so no signal can reach it, not even at its first instruction.
class SignalsBlocked {
 public:
  SignalsBlocked() noexcept {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_{};
};

/// A flood must not take the CPU from a control loop whose priority this thread has inherited.
void give_up_real_time() noexcept {
  const sched_param none{};
  ::pthread_setschedparam(::pthread_self(), SCHED_OTHER, &none);
}

}  // namespace

struct Receiver::Hearing {
  Hearing(const wire::Address& from, const Options& options)
      : address{from}, intake{options.model_hash, options.verifier} {}

  void run() noexcept {
    give_up_real_time();
    while (!is_stopping()) {
      Status status = inlet.wait(static_cast<int>(kLookUp.count()));
      if (status == Status::ok) {
        status = take_packets(inlet, intake, [this](auto what, Timestamp t_receipt) { hand_over(what, t_receipt); });
      }
      if (status == Status::io_error) mend(errno);
      counters.back() = intake.counters();
      counters.back().broken_frames = inlet.broken_frames();
      counters.publish();
    }
  }

  void mend(int error) noexcept {
    ++failures;
    do {
      tell({Health::State::broken, error, failures});
      std::this_thread::sleep_for(kLookUp);
      if (is_stopping()) return;
      error = inlet.open(address).empty() ? 0 : errno;
    } while (error != 0);
    tell({Health::State::listening, 0, failures});
  }

  void tell(const Health& now) noexcept {
    health.back() = now;
    health.publish();
  }

  bool is_stopping() const noexcept { return stopping.load(std::memory_order_relaxed); }

  void hand_over(Intake::Taken what, Timestamp t_receipt) noexcept {
    if (what == Intake::Taken::model) {
      names.back() = {.any = true, .model = intake.message().model};
      names.publish();
    } else {
      heard.back() = {.any = true, .t_receipt = t_receipt, .estimate = intake.message().estimate};
      heard.publish();
    }
  }

  const wire::Address address;
  hal::PacketInlet inlet;
  Intake intake;
  std::uint64_t failures{};
  TripleBuffer<Heard> heard;
  TripleBuffer<Names> names;
  TripleBuffer<Counters> counters;
  TripleBuffer<Health> health;
  std::atomic<bool> stopping{false};
  std::thread thread;
};

Receiver::Receiver() = default;
Receiver::~Receiver() { stop(); }

Status Receiver::start(const Options& options) {
  stop();
  wire::Address address;
  if (const auto why = wire::parse_address(options.address, address); !why.empty()) {
    problem_ = options.address + ": " + std::string{why};
    return Status::bad_argument;
  }
  if (!(options.horizon_s >= 0 && options.horizon_s <= 10)) {
    problem_ = "the horizon of the prediction is a time from 0 to 10 s";
    return Status::bad_argument;
  }
  horizon_s_ = options.horizon_s;
  auto hearing = std::make_unique<Hearing>(address, options);
  if (const auto failed = hearing->inlet.open(address); !failed.empty()) {
    const int error = errno;
    problem_ = hal::place_of(address).append(" ").append(failed);
    if (error == 0) return Status::bad_argument;
    problem_.append(": ").append(std::strerror(error));
    return Status::io_error;
  }
  hearing->tell({.state = Health::State::listening});
  try {
    const SignalsBlocked blocked;
    hearing->thread = std::thread{[own = hearing.get()] { own->run(); }};
  } catch (const std::system_error& error) {
    problem_ = std::string{"the receiving thread cannot be started: "} + error.what();
    return Status::io_error;
  }
  hearing_ = std::move(hearing);
  return Status::ok;
}

void Receiver::stop() noexcept {
  if (hearing_ == nullptr) return;
  hearing_->stopping.store(true, std::memory_order_relaxed);
  hearing_->thread.join();
  hearing_.reset();
}

Reading Receiver::newest(Timestamp now) noexcept {
  Reading reading;
  if (hearing_ == nullptr) return reading;
  const Heard& heard = hearing_->heard.newest();
  if (!heard.any) return reading;
  reading.estimate = heard.estimate;
  reading.silence_s = std::max(0.0, seconds_between(heard.t_receipt, now));
  reading.age_s = seconds_between(heard.estimate.t_capture, heard.estimate.t_send) + reading.silence_s;
  const bool finite = predict(reading.estimate, std::clamp(reading.age_s, 0.0, horizon_s_));
  reading.freshness = finite && reading.age_s <= horizon_s_ ? Freshness::fresh : Freshness::stale;
  return reading;
}

bool Receiver::model(wire::ModelMessage& out) noexcept {
  if (hearing_ == nullptr) return false;
  const Names& names = hearing_->names.newest();
  if (names.any) out = names.model;
  return names.any;
}

Counters Receiver::counters() noexcept { return hearing_ == nullptr ? Counters{} : hearing_->counters.newest(); }

Health Receiver::health() noexcept { return hearing_ == nullptr ? Health{} : hearing_->health.newest(); }

Timestamp Receiver::now() noexcept { return hal::MonotonicClock{}.now(); }

}  // namespace articam::receiver
