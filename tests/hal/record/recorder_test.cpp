#include "hal/record/recorder.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <vector>

#include "core/model/table_hash.hpp"
#include "hal/firmware.hpp"
#include "hal/memory/manual_clock.hpp"
#include "hal/memory/memory_camera.hpp"
#include "hal/record/recording_ports.hpp"
#include "hal/record/replayed_ports.hpp"
#include "hal/run_loop.hpp"
#include "host_sim/scenarios/paper.hpp"
#include "tests/support/own_folder.hpp"
#include "tests/support/small_files.hpp"

namespace articam {
namespace {

namespace fs = std::filesystem;
using Scenario = sim::PaperScenario;
using M = Scenario::Model;
using Tracker = tracker::Tracker<M, float>;
using Estimate = Tracker::EstimateType;

struct KeptLink {
  std::vector<Estimate> estimates;
  Status publish(const Estimate& estimate) noexcept { return estimates.push_back(estimate), Status::ok; }
};

bool same_bits(const Estimate& a, const Estimate& b) {
  return a.frame == b.frame && a.t_capture == b.t_capture && a.status == b.status && a.reason == b.reason &&
         a.valid == b.valid && a.q.T_cam_obj.t == b.q.T_cam_obj.t &&
         a.q.T_cam_obj.R.coeffs() == b.q.T_cam_obj.R.coeffs() && a.q.joints == b.q.joints && a.qdot == b.qdot &&
         a.covariance == b.covariance && a.observability == b.observability && a.matched == b.matched &&
         a.rms_px == b.rms_px;
}

class Recording : public testing::Test {
 protected:
  Recording() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    sim::Renderer renderer{Scenario::camera(), {}};
    for (std::uint32_t i = 0; i < images_.size(); ++i) {
      renderer.render(sim::scene_markers<M>(Scenario::at(Scenario::kRest_s + i / 30.0).q), i, images_[i]);
    }
    header_.model_hash = model::table_hash<M>();
    header_.scalar_bytes = sizeof(float);
    header_.camera = Scenario::camera();
    header_.period_ns = kTimes.period.count();
    header_.max_age_s = kTimes.max_age_s;
  }
  ~Recording() override { fs::remove_all(folder_); }

  /// 60 ticks with all that can happen: silences, duplicates, late frames, one of the wrong size.
  std::vector<Estimate> run() {
    const auto tracker = std::make_unique<Tracker>(Scenario::camera());
    hal::MemoryCamera memory;
    hal::ManualClock manual;
    KeptLink link;
    hal::RecordingCamera camera{memory, recorder_};
    hal::RecordingClock clock{manual, recorder_};
    hal::RecordingTracker recorded{*tracker, recorder_};
    hal::RunLoop loop{camera, clock, link, recorded, kTimes};
    for (std::uint32_t k = 0; k < 60; ++k) {
      const Timestamp t = from_seconds(100 + k / 30.0);
      manual.set(k == 25 ? from_seconds(100 + k / 30.0 + 0.2) : t);
      const auto& image = images_[k % images_.size()];
      const std::uint32_t sequence = k == 10 ? k - 1 : k;
      const int height_px = k == 15 ? 300 : 480;
      if (k % 20 < 17) memory.hand_over({{image.data(), 640, height_px, 640}, t, sequence});
      (void)loop.run_once();
    }
    return link.estimates;
  }

  static std::vector<Estimate> replay(const hal::Recording& recording) {
    const auto tracker = std::make_unique<Tracker>(recording.header.camera, recording.header.options);
    hal::Playback playback{recording};
    hal::ReplayedCamera camera{playback};
    hal::ReplayedClock clock{playback};
    hal::ReplayedTracker<Tracker> replayed{*tracker, playback};
    KeptLink link;
    hal::RunLoop loop{camera, clock, link, replayed, kTimes};
    while (loop.run_once() != hal::Tick::ended) {
    }
    return link.estimates;
  }

  std::vector<char> bytes() const {
    std::ifstream stream{ticks_, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
  }
  void write(const std::vector<char>& bytes, std::size_t size) const {
    std::ofstream{ticks_, std::ios::binary}.write(bytes.data(), static_cast<std::streamsize>(size));
  }

  /// In place: a file that is emptied and written anew thousands of times waits for the disk.
  void flip(std::size_t bit) const {
    std::fstream stream{ticks_, std::ios::binary | std::ios::in | std::ios::out};
    const auto place = static_cast<std::streamoff>(bit / 8);
    const int byte = stream.seekg(place).get();
    stream.seekp(place).put(static_cast<char>(byte ^ (1 << (bit % 8))));
  }

  static constexpr hal::LoopTimes kTimes{.period = std::chrono::nanoseconds{33'333'333}};
  std::string why_;
  std::vector<std::vector<std::uint8_t>> images_{12};
  hal::RecordingHeader header_{};
  hal::Recorder recorder_;
  fs::path folder_ = test::own_folder();
  std::string ticks_ = (folder_ / "run.rec").string(), frames_ = (folder_ / "run.frames").string();
};

TEST_F(Recording, GivesTheSameEstimatesBitForBit) {
  ASSERT_EQ(recorder_.open_ticks(ticks_, 1 << 20, header_), Status::ok) << recorder_.problem();
  const auto estimates = run();
  ASSERT_EQ(recorder_.close(), Status::ok) << recorder_.problem();
  EXPECT_EQ(recorder_.counters().ticks, 60u);

  const auto recording = hal::read_recording(ticks_, why_);
  ASSERT_TRUE(recording) << why_;
  EXPECT_FALSE(recording->torn);
  const auto again = replay(*recording);
  ASSERT_EQ(again.size(), estimates.size());
  bool seen[6]{};
  for (std::size_t k = 0; k < again.size(); ++k) {
    EXPECT_TRUE(same_bits(again[k], estimates[k])) << "tick " << k;
    seen[static_cast<int>(again[k].status)] = true;
  }
  EXPECT_TRUE(seen[static_cast<int>(tracker::TrackingStatus::tracking)]);
  EXPECT_TRUE(seen[static_cast<int>(tracker::TrackingStatus::coasting)]);
  EXPECT_TRUE(seen[static_cast<int>(tracker::TrackingStatus::degraded)]);  // the camera was silent for three periods
}

TEST_F(Recording, KeepsTheLastFramesInARing) {
  ASSERT_EQ(recorder_.open_ticks(ticks_, 1 << 20, header_), Status::ok);
  ASSERT_EQ(recorder_.open_frames(frames_, 5, header_), Status::ok) << recorder_.problem();
  (void)run();
  ASSERT_EQ(recorder_.close(), Status::ok);
  const auto recording = hal::read_recording(ticks_, why_);
  ASSERT_TRUE(recording) << why_;
  const auto frames = hal::read_frames(frames_, recording->header, why_);
  ASSERT_EQ(frames.size(), 5u) << why_;
  std::vector<std::uint32_t> ticks_with_frame;
  for (const auto& tick : recording->ticks) {
    if (tick.record.camera == Status::ok) ticks_with_frame.push_back(tick.record.tick);
  }
  const auto& counters = recorder_.counters();
  EXPECT_EQ(counters.frames + counters.frames_missed, ticks_with_frame.size());
  std::size_t i = ticks_with_frame.size() - 5;
  for (const auto& [tick, frame] : frames) {
    // This loop is not paced: a writer that was behind has left some out, and then those before them are there still.
    if (counters.frames_missed == 0) {
      EXPECT_EQ(tick, ticks_with_frame[i++]);
    }
    EXPECT_TRUE(frame.pixels == images_[tick % images_.size()]) << tick;
  }
}

TEST_F(Recording, IsReadToTheLastWholeTickWhereverThePowerWent) {
  ASSERT_EQ(recorder_.open_ticks(ticks_, 1 << 20, header_), Status::ok);
  (void)run();
  ASSERT_EQ(recorder_.close(), Status::ok);
  const auto whole = hal::read_recording(ticks_, why_);
  ASSERT_TRUE(whole) << why_;
  const auto file = bytes();
  constexpr std::uint32_t kSeed = 7;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random{kSeed};
  for (int i = 0; i < 200; ++i) {
    const std::size_t size = random() % file.size();
    write(file, size);
    const auto cut = hal::read_recording(ticks_, why_);
    EXPECT_EQ(cut.has_value(), size >= sizeof(hal::RecordingHeader)) << size;
    if (!cut) continue;
    std::size_t bytes = sizeof(hal::RecordingHeader), whole_ticks = 0;
    while (whole_ticks < whole->ticks.size() && bytes + whole->ticks[whole_ticks].record.bytes <= size) {
      bytes += whole->ticks[whole_ticks++].record.bytes;
    }
    EXPECT_EQ(cut->ticks.size(), whole_ticks) << size;
    EXPECT_EQ(cut->torn, bytes != size) << size;
  }
}

TEST_F(Recording, EndsBeforeATickWithAFlippedBit) {
  ASSERT_EQ(recorder_.open_ticks(ticks_, 1 << 20, header_), Status::ok);
  (void)run();
  ASSERT_EQ(recorder_.close(), Status::ok);
  const auto whole = hal::read_recording(ticks_, why_);
  ASSERT_TRUE(whole) << why_;
  std::size_t begin = sizeof(hal::RecordingHeader);
  for (int i = 0; i < 5; ++i) begin += whole->ticks[static_cast<std::size_t>(i)].record.bytes;
  for (std::size_t bit = 0; bit < 8u * whole->ticks[5].record.bytes; ++bit) {
    flip(8 * begin + bit);
    const auto damaged = hal::read_recording(ticks_, why_);
    ASSERT_TRUE(damaged);
    ASSERT_EQ(damaged->ticks.size(), 5u) << "bit " << bit;
    ASSERT_TRUE(damaged->torn);
    flip(8 * begin + bit);
  }
}

TEST_F(Recording, EndsWhenItsFileIsFullAndSaysWhatIsMissing) {
  constexpr std::size_t kSmall = sizeof(hal::RecordingHeader) + 3000;
  ASSERT_EQ(recorder_.open_ticks(ticks_, kSmall, header_), Status::ok);
  (void)run();
  ASSERT_EQ(recorder_.close(), Status::ok);
  EXPECT_EQ(recorder_.counters().ticks + recorder_.counters().ticks_missed, 60u);
  const auto recording = hal::read_recording(ticks_, why_);
  ASSERT_TRUE(recording) << why_;
  EXPECT_EQ(recording->ticks.size(), recorder_.counters().ticks);
  EXPECT_LE(fs::file_size(ticks_), kSmall);
}

TEST_F(Recording, RefusesADiskWithoutRoomBeforeTheFirstTick) {
  const test::SmallFiles disk{4096};
  EXPECT_EQ(recorder_.open_ticks(ticks_, 1 << 20, header_), Status::io_error);
  EXPECT_NE(recorder_.problem().find(ticks_), std::string::npos);
  EXPECT_EQ(recorder_.close(), Status::ok);
}

TEST_F(Recording, IsRefusedWhenItIsOfAnotherVersionOrNone) {
  std::vector<char> file(4096);
  write(file, file.size());
  EXPECT_FALSE(hal::read_recording(ticks_, why_));
  EXPECT_NE(why_.find("is no recording"), std::string::npos) << why_;
  header_.header_bytes += 8;
  std::memcpy(file.data(), &header_, sizeof header_);
  write(file, file.size());
  EXPECT_FALSE(hal::read_recording(ticks_, why_));
  EXPECT_NE(why_.find("another version"), std::string::npos) << why_;
  header_.header_bytes -= 8;
  header_.schema += 1;
  std::memcpy(file.data(), &header_, sizeof header_);
  write(file, file.size());
  EXPECT_FALSE(hal::read_recording(ticks_, why_));
  EXPECT_NE(why_.find("another version"), std::string::npos) << why_;
  EXPECT_FALSE(hal::read_recording((folder_ / "none").string(), why_));
}

TEST_F(Recording, IsRefusedWithAFlippedBitInWhatAllItsTicksRestOn) {
  ASSERT_EQ(recorder_.open_ticks(ticks_, 1 << 20, header_), Status::ok);
  ASSERT_EQ(recorder_.close(), Status::ok);
  for (std::size_t bit = 0; bit < 8 * sizeof(hal::RecordingHeader); ++bit) {
    ASSERT_TRUE(hal::read_recording(ticks_, why_)) << why_;
    flip(bit);
    ASSERT_FALSE(hal::read_recording(ticks_, why_)) << "bit " << bit;
    flip(bit);
  }
}

TEST_F(Recording, KeepsTheOneThatWasThereBefore) {
  std::ofstream{ticks_} << "what went wrong";
  ASSERT_EQ(recorder_.open_ticks(ticks_, 1 << 20, header_), Status::ok);
  ASSERT_EQ(recorder_.close(), Status::ok);
  EXPECT_EQ(fs::file_size(ticks_ + ".before"), 15u);
}

}  // namespace
}  // namespace articam
