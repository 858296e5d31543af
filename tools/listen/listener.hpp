#pragma once
/// @file  The listener's arrow: a packet in, an estimate with names and times out.

#include <cstdint>
#include <map>

#include "tools/listen/decode.hpp"
#include "tools/listen/session.hpp"
#include "tools/listen/statistics.hpp"

namespace articam::listen {

/// Whatever comes, work and memory are bounded. Boards may share a group: each has its session.
class Listener {
 public:
  static constexpr std::size_t kMaxSessions = 16;  ///< the one silent for longest is forgotten, its counts are kept

  explicit Listener(Session::Deliver deliver, wire::Verifier* verifier = nullptr)
      : deliver_{std::move(deliver)}, decoder_{verifier} {}

  void take(const Received& received);
  /// Of a serial line, so far.
  void set_broken_frames(std::uint64_t count) { statistics_.broken_frames = count; }
  /// Up to now; valid until the next call.
  const Statistics& statistics();

 private:
  struct Entry {
    Session session;
    std::uint64_t last_packet{};
  };

  wire::Fault take_message(const Received& received);
  wire::Fault take_estimate(const Received& received);
  Session& session_of(std::uint64_t id);

  Session::Deliver deliver_;
  Decoder decoder_;
  wire::Message message_;
  std::map<std::uint64_t, Entry> sessions_;
  std::uint64_t packets_{};
  Counts forgotten_;
  std::uint64_t forgotten_unnamed_{};
  Statistics statistics_;
};

}  // namespace articam::listen
