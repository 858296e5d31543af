#include "hal/receiver/receiver.hpp"

#include <pthread.h>
#include <sched.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <utility>

#include "hal/receiver/intake.hpp"
#include "hal/receiver/prediction.hpp"
#include "hal/receiver/triple_buffer.hpp"
#include "hal/receiver/udp_inlet.hpp"

namespace articam::receiver {
namespace {

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
  explicit Hearing(const Options& options) : intake{options.model_hash, options.verifier} {}

  void run() noexcept {
    constexpr int kLookUp_ms = 100;  // how soon stop() is noticed
    give_up_real_time();
    while (!stopping.load(std::memory_order_relaxed)) {
      const Status status = inlet.wait(kLookUp_ms);
      if (status == Status::io_error) return;
      if (status != Status::ok) continue;
      inlet.read(intake, [this](Intake::Taken what, Timestamp t_receipt) { hand_over(what, t_receipt); });
      counters.back() = intake.counters();
      counters.publish();
    }
  }

  void hand_over(Intake::Taken what, Timestamp t_receipt) noexcept {
    if (what == Intake::Taken::model) {
      names.back() = {.any = true, .model = intake.message().model};
      names.publish();
    } else {
      heard.back() = {.any = true, .t_receipt = t_receipt, .estimate = intake.message().estimate};
      heard.publish();
    }
  }

  UdpInlet inlet;
  Intake intake;
  TripleBuffer<Heard> heard;
  TripleBuffer<Names> names;
  TripleBuffer<Counters> counters;
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
  auto hearing = std::make_unique<Hearing>(options);
  if (const Status status = hearing->inlet.open(address, problem_); status != Status::ok) return status;
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

Timestamp Receiver::now() noexcept { return UdpInlet::now(); }

}  // namespace articam::receiver
