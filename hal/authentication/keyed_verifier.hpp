#pragma once
/// @file  Tells the packets of the board from everybody else's, and from its own of yesterday.

#include <cstdint>
#include <optional>
#include <string>

#include "hal/authentication/counter_file.hpp"
#include "hal/authentication/key.hpp"

namespace articam::hal {

/// A counter must be larger than every one before it; what was overtaken on the way counts as replayed, too. With a
/// state file that also holds over a restart of the controller: it is written when the verifier goes, and on the way
/// when kStride counters have passed. After a loss of power, at most so many old packets could be played back, and only
/// until the board itself is heard again.
class KeyedVerifier final : public wire::Verifier {
 public:
  static constexpr std::uint64_t kStride = 4096;  // a write every 34 s at 120 packets a second

  explicit KeyedVerifier(const Key& key) : key_{key} {}
  ~KeyedVerifier() { save(); }
  KeyedVerifier(const KeyedVerifier&) = delete;
  KeyedVerifier& operator=(const KeyedVerifier&) = delete;

  /// Remembers in that file from now on. May be left out.
  /// Errors  io_error, bad_argument; problem() is then a sentence.
  Status open(const std::string& state_path);
  const std::string& problem() const noexcept { return problem_; }

  wire::Fault admit(std::span<const std::uint8_t> covered, std::uint64_t counter, wire::ConstTag tag) noexcept override;

 private:
  void save() noexcept;

  Key key_;
  std::optional<CounterFile> file_;
  std::string problem_;
  std::uint64_t least_{};  ///< that is new
  std::uint64_t saved_{};
};

}  // namespace articam::hal
