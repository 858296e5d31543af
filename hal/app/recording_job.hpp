#pragma once
/// @file  A board's recording through the loop again: the same estimates, bit for bit.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.hpp"
#include "core/model/table_hash.hpp"
#include "hal/app/identification.hpp"
#include "hal/app/start.hpp"
#include "hal/firmware.hpp"
#include "hal/link/file_link.hpp"
#include "hal/link/tee_link.hpp"
#include "hal/record/replayed_ports.hpp"
#include "hal/run_loop.hpp"

namespace articam::app {

struct RecordingOptions {
  std::string recording, frames, output;  ///< `frames` may be empty
  identify::JobOptions identify;          ///< without outputs: nothing is to be identified
};

/// Where the recorded frames are there, the tracker looks at them too and must see what was recorded.
template <class Tracker>
class CheckedTracker {
 public:
  using EstimateType = typename Tracker::EstimateType;
  using Frames = std::map<std::uint32_t, hal::RecordedFrame>;

  CheckedTracker(Tracker& tracker, hal::ReplayedTracker<Tracker>& replayed, const hal::Playback& playback,
                 const Frames& frames)
      : tracker_{tracker}, replayed_{replayed}, playback_{playback}, frames_{frames} {}

  EstimateType step(const ImageView& none, Timestamp t) noexcept {
    const hal::RecordedTick& tick = playback_.current();
    const auto frame = frames_.find(tick.record.tick);
    if (frame == frames_.end() || tick.record.mismatched != 0) return replayed_.step(none, t);
    const EstimateType estimate = tracker_.step(frame->second.view(), t);
    ++looked_at_;
    if (!same(tracker_.detections(), tick.detections)) ++different_;
    return estimate;
  }
  EstimateType coast(Timestamp t, tracker::Reason why) const noexcept { return replayed_.coast(t, why); }

  std::size_t looked_at() const noexcept { return looked_at_; }
  std::size_t different() const noexcept { return different_; }

 private:
  static bool same(const vision::Detections& a, const vision::Detections& b) noexcept {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

  Tracker& tracker_;
  hal::ReplayedTracker<Tracker>& replayed_;
  const hal::Playback& playback_;
  const Frames& frames_;
  std::size_t looked_at_{}, different_{};
};

/// Writes estimates.csv, one row a tick, and prints a summary. Returns what went wrong, or nothing.
template <class Model>
std::string play(const RecordingOptions& options, Sightings& sightings) {
  using Tracker = tracker::Tracker<Model, DefaultScalar>;
  using Estimate = typename Tracker::EstimateType;
  std::string why;
  const auto recording = hal::read_recording(options.recording, why);
  if (!recording) return why;
  const hal::RecordingHeader& header = recording->header;
  if (header.model_hash != model::table_hash<Model>()) {
    return fmt::format("{}: was recorded for another model, '{}'", options.recording, header.model_name.data());
  }
  if (header.scalar_bytes != sizeof(DefaultScalar)) {
    return fmt::format("{}: was recorded by a tracker of {} bytes a number, this one has {}", options.recording,
                       header.scalar_bytes, sizeof(DefaultScalar));
  }
  typename CheckedTracker<Tracker>::Frames frames;
  if (!options.frames.empty()) {
    frames = hal::read_frames(options.frames, header, why);
    if (!why.empty()) return why;
  }

  sightings.camera = header.camera;
  const auto tracker = std::make_unique<Tracker>(header.camera, header.options);
  if (header.num_start > 0) {
    const std::vector<double> start{header.start.begin(), header.start.begin() + header.num_start};
    if (why = set_start(*tracker, std::optional{start}, "of the recording"); !why.empty()) return why;
  }
  hal::Playback playback{*recording};
  hal::ReplayedCamera camera{playback};
  hal::ReplayedClock clock{playback};
  hal::ReplayedTracker<Tracker> replayed{*tracker, playback};
  CheckedTracker<Tracker> checked{*tracker, replayed, playback, frames};
  hal::FileLink<Estimate> file;
  hal::TeeLink<Estimate, hal::FileLink<Estimate>> link{file};
  hal::RunLoop loop{camera, clock, link, checked,
                    hal::LoopTimes{std::chrono::nanoseconds{header.period_ns}, header.max_age_s}};
  if (file.open(options.output) != Status::ok) return file.problem();
  while (loop.run_once() != hal::Tick::ended) {
    if (loop.counters().link_errors > 0) return file.problem();
    if (!options.identify.outputs.empty()) note_sightings(*tracker, link.latest(), sightings.recording);
  }
  if (file.close() != Status::ok) return file.problem();
  fmt::print("ticks        {}{}\n", recording->ticks.size(), recording->torn ? ", then torn: the power went" : "");
  if (frames.empty()) return {};
  fmt::print("looked at    {} frames again, {} seen otherwise than recorded\n", checked.looked_at(),
             checked.different());
  return checked.different() == 0 ? std::string{} : "the detector does not see what was recorded";
}

/// The same, and identifies what was asked for.
template <class Model>
std::string replay_recording(const RecordingOptions& options) {
  return identify_from<Model>(options.identify,
                              [&options](Sightings& sightings) { return play<Model>(options, sightings); });
}

}  // namespace articam::app
