#include "hal/app/board/board_options.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <map>

namespace articam::app {
namespace {

constexpr const char* kFooter = R"(
Examples
  {0} --link udp://192.168.1.10 --rate 60 --cpu 3
  {0} --camera v4l2:/dev/video0 --exposure-us 4000 --gain 2 --link serial:///dev/ttyS1?baud=921600
  {0} --camera replay:frames --frames 500 --link stdout     one CSV row a tick instead of packets

What it sends is heard by articam-listen and by the library articam::receiver.
Exit codes: 0 stopped, 1 no camera, or the job failed, 2 wrong usage.)";

/// "v4l2:/dev/video0" -> source and device; what is wrong, or nothing.
std::string read_camera_option(const std::string& text, BoardOptions& options) {
  using Source = BoardOptions::Source;
  const std::size_t colon = text.find(':');
  const std::string word = text.substr(0, colon);
  options.device = colon == std::string::npos ? std::string{} : text.substr(colon + 1);
  if (word == "libcamera") return options.source = Source::libcamera, std::string{};
  if (word != "v4l2" && word != "replay")
    return "'" + text + "' is not libcamera, libcamera:ID, v4l2:DEV or replay:DIR";
  options.source = word == "v4l2" ? Source::v4l2 : Source::replay;
  if (!options.device.empty()) return {};
  return word == "v4l2" ? "v4l2 needs a device, for example v4l2:/dev/video0"
                        : "replay needs a folder of PGM frames, for example replay:frames";
}

void declare_camera(CLI::App& app, BoardOptions& options) {
  app.add_option_function<std::string>(
         "--camera",
         [&options](const std::string& text) {
           if (const auto wrong = read_camera_option(text, options); !wrong.empty()) {
             throw CLI::ValidationError("--camera", wrong);
           }
         },
         "libcamera: the first camera; libcamera:ID; v4l2:DEV; replay:DIR plays PGM frames again and again")
      ->type_name("SOURCE")
      ->default_str("libcamera");
  app.add_option("--rate", options.rate_hz, "frames per second")->capture_default_str()->check(CLI::Range(0.1, 1000.0));
  app.add_option("--exposure-us", options.exposure_us, "exposure time, microseconds (default: automatic)")
      ->check(CLI::Range(1.0, 1e6));
  app.add_option("--gain", options.gain, "sensor gain; v4l2: in the device's own units (default: automatic)")
      ->check(CLI::Range(0.0, 65535.0));
  app.add_option(
         "--stamp", options.stamp,
         "what libcamera's time stamp marks: the start of the exposure, or of the readout (default: readout where the "
         "camera tells the exposure of each frame, as those on CSI do)")
      ->transform(CLI::CheckedTransformer(std::map<std::string, hal::StampMarks>{
          {"exposure", hal::StampMarks::exposure_start}, {"readout", hal::StampMarks::readout_start}}))
      ->option_text("exposure|readout");
  app.add_option("--frames", options.num_frames, "stop after so many frames (0: never)");
}

void declare_link(CLI::App& app, BoardOptions& options) {
  app.add_option("--link", options.link,
                 "udp://HOST[:PORT], a multicast group likewise, serial://DEV[?baud=N], or stdout (to try out: the "
                 "loop waits for its reader)")
      ->capture_default_str();
  auto* const key = app.add_option("--key", options.key_file, "authenticate packets with this key (32 bytes)");
  auto* const counter =
      app.add_option("--counter", options.counter_file, "where the packets' counter survives a restart");
  key->needs(counter);
  counter->needs(key);
}

void declare_process(CLI::App& app, BoardOptions& options) {
  app.add_option("--priority", options.priority, "real-time priority (0: none)")
      ->capture_default_str()
      ->check(CLI::Range(0, 99));
  app.add_option("--cpu", options.cpu, "run the loop on this processor")->check(CLI::Range(0, 1023));
  app.add_flag("--quiet", options.quiet, "no statistics every second");
}

void declare_tracker(CLI::App& app, BoardOptions& options) {
  app.add_option("--q0", options.q0, "'px py pz qw qx qy qz q1 q2 ...' (default: the model's own)");
  app.add_option("--mode", options.mode, "default: iterated in every frame; paper: one step a frame")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, tracker::Mode>{{"default", tracker::Mode::standard}, {"paper", tracker::Mode::paper}}))
      ->option_text("default|paper");
}

void declare_recording(CLI::App& app, BoardOptions& options) {
  app.add_option("--record", options.record, "record detections into this file; articam-replay --recording reads it");
  app.add_option("--record-mb", options.record_mb, "its size; recording ends when it is full")
      ->capture_default_str()
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 20));
  app.add_option("--record-frames", options.record_frames, "keep the last frames in this file")->needs("--record");
  app.add_option("--record-seconds", options.record_seconds, "how many seconds of them")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 3600.0));
}

/// What is wrong with options that are right one by one, or nothing.
std::string read_link(BoardOptions& options) {
  if (options.link == "stdout") {
    return options.key_file.empty() ? std::string{} : "--key authenticates packets, and --link stdout sends none";
  }
  const auto wrong = wire::parse_address(options.link, options.address);
  return wrong.empty() ? std::string{} : "--link " + options.link + ": " + std::string(wrong);
}

}  // namespace

std::variant<BoardOptions, int> read_board_options(const BoardTitle& title, int argc, char** argv) {
  CLI::App app{fmt::format("Estimates the configuration of '{}' from the camera '{}' and sends it to a controller.",
                           title.model, title.camera),
               title.name};
  BoardOptions options;
  app.footer(fmt::format(fmt::runtime(kFooter), title.name));
  app.set_version_flag("--version", title.name + " " + title.version);
  declare_camera(app, options);
  declare_link(app, options);
  declare_process(app, options);
  declare_tracker(app, options);
  declare_recording(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? 0 : 2;
  }
  if (const std::string wrong = read_link(options); !wrong.empty()) {
    fmt::print(stderr, "{}\nRun with --help for more information.\n", wrong);
    return 2;
  }
  return options;
}

}  // namespace articam::app
