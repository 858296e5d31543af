// A libFuzzer target: any bytes as a frame, as the detector's options and as what is asked of it. What must hold is
// said by LAW.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/vision/detector.hpp"
#include "tests/fuzz/detector/odd_frame.hpp"

namespace {

using namespace articam;
using namespace articam::vision;

void law(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken law: %s\n", what);
  std::abort();  // libFuzzer keeps the input
}

DetectorOptions odd_options(FuzzedDataProvider& bytes) {
  DetectorOptions options;
  options.rings = bytes.ConsumeBool();
  options.dots_light_on_dark = bytes.ConsumeBool();
  options.dots_dark_on_light = bytes.ConsumeBool();
  if (bytes.ConsumeBool()) options.ring_ratio_q16 = bytes.ConsumeIntegralInRange(kMinRingRatio_q16, kMaxRingRatio_q16);
  if (bytes.ConsumeIntegral<std::uint8_t>() == 1) options.ring_ratio_q16 = bytes.ConsumeIntegral<std::int32_t>();
  if (bytes.ConsumeBool()) {
    options.camera = {bytes.ConsumeIntegral<std::int32_t>(), bytes.ConsumeIntegral<std::int32_t>(),
                      bytes.ConsumeIntegral<std::int32_t>(), bytes.ConsumeIntegral<std::int32_t>()};
  } else if (bytes.ConsumeBool()) {
    options.camera = {bytes.ConsumeIntegralInRange(kMinFocal_q16, 4096 << 16),
                      bytes.ConsumeIntegralInRange(0, 640 << 16), bytes.ConsumeIntegralInRange(0, 480 << 16),
                      bytes.ConsumeIntegralInRange(0, 1 << 16)};
  }
  return options;
}

std::vector<PixelBox> odd_windows(FuzzedDataProvider& bytes) {
  std::vector<PixelBox> windows;
  for (int n = bytes.ConsumeIntegralInRange(0, 3); n > 0; --n) {
    if (bytes.ConsumeIntegral<std::uint8_t>() < 16) {
      windows.push_back({bytes.ConsumeIntegral<int>(), bytes.ConsumeIntegral<int>(), bytes.ConsumeIntegral<int>(),
                         bytes.ConsumeIntegral<int>()});
    } else {
      const int u = bytes.ConsumeIntegralInRange(-20, 110), v = bytes.ConsumeIntegralInRange(-20, 90);
      windows.push_back({u, v, u + bytes.ConsumeIntegralInRange(-1, 90), v + bytes.ConsumeIntegralInRange(-1, 90)});
    }
  }
  return windows;
}

// What was found, a little off or badly off, and numbers that mean nothing.
std::vector<Expected> odd_expectations(FuzzedDataProvider& bytes, const Detections& found) {
  std::vector<Expected> expected;
  for (const Detection& mark : found) {
    Ellipse e = mark.outer;
    const auto moved = [&bytes](std::int32_t q16, std::int32_t by) {
      return q16 + bytes.ConsumeIntegralInRange<std::int32_t>(-by, by);
    };
    if (bytes.ConsumeBool()) {
      e = {moved(e.u_q16, e.m00_q16 / 2), moved(e.v_q16, e.m11_q16 / 2), moved(e.m00_q16, e.m00_q16 / 2),
           moved(e.m10_q16, e.m11_q16 / 2), moved(e.m11_q16, e.m11_q16 / 2)};
    }
    expected.push_back({mark.kind, e});
  }
  for (int n = bytes.ConsumeIntegralInRange(0, 4); n > 0; --n) {
    const auto kind = static_cast<MarkKind>(bytes.ConsumeIntegralInRange(0, 2));
    const int bits = bytes.ConsumeIntegralInRange(20, 31);  // 16 px to the whole of the type
    const auto number = [&bytes, bits] { return bytes.ConsumeIntegral<std::int32_t>() >> (31 - bits); };
    expected.push_back({kind, {number(), number(), number(), number(), number()}});
  }
  return expected;
}

bool is_ellipse(const Ellipse& e) {
  const std::int64_t most = std::int64_t{2} * std::max(kMaxImageWidth_px, kMaxImageHeight_px) << kQ16;
  return e.m00_q16 > 0 && e.m11_q16 > 0 && e.m00_q16 <= most && e.m11_q16 <= most;
}

bool has_centre_within(const Ellipse& e, const PixelBox& box) {
  const std::int64_t u = e.u_q16, v = e.v_q16, q = 1 << kQ16;
  return u >= box.u_min_px * q && u <= box.u_max_px * q && v >= box.v_min_px * q && v <= box.v_max_px * q;
}

void check(const Detections& found, const ImageView& image) {
  const PixelBox whole{0, 0, image.width_px - 1, image.height_px - 1};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Detection& mark = found[i];
    law(is_ellipse(mark.outer), "an outer edge is an ellipse");
    law(has_centre_within(mark.outer, whole), "a mark lies in the frame");
    law(mark.centre_variance_q24 > 0 && mark.axis_variance_q24 > 0, "nothing is known exactly");
    law(mark.flaws <= (kBlurred | kSaturated | kOccluded | kClipped), "flaws are those that have a name");
    if (mark.kind == MarkKind::ring) {
      law(is_ellipse(mark.inner), "a ring's hole is an ellipse");
      law(mark.inner.m00_q16 < mark.outer.m00_q16, "a hole is smaller than its ring");
      law(mark.inner_centre_variance_q24 > 0 && mark.inner_axis_variance_q24 > 0, "no hole is known exactly");
    } else {
      law(mark.inner == Ellipse{}, "a dot has no hole");
    }
    law(i == 0 || found[i - 1].outer.v_q16 <= mark.outer.v_q16, "marks come in the order of their rows");
  }
}

void check_kinds(const Detections& found, const DetectorOptions& options) {
  for (const Detection& mark : found) {
    law(mark.kind == MarkKind::ring                ? options.rings
        : mark.kind == MarkKind::dot_light_on_dark ? options.dots_light_on_dark
                                                   : options.dots_dark_on_light,
        "only what is sought is found");
  }
}

bool equal(const Detections& a, const Detections& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes{data, size};
  const fuzz::OddFrame frame = fuzz::odd_frame(bytes), other = frame.with_padding(255);
  const ImageView image = frame.view();
  const DetectorOptions options = odd_options(bytes);
  const auto detector = std::make_unique<Detector>(options);
  Detections whole, again;
  if (!options.ok()) {
    law(detector->detect(image, whole) == Status::bad_argument, "a ratio out of range is refused");
    law(detector->measure(image, {}, whole) == Status::bad_argument, "a ratio out of range is refused");
    return 0;
  }

  law(detector->detect(image, whole) == Status::ok, "a frame is searched");
  check(whole, image);
  check_kinds(whole, options);
  const bool overloaded = detector->overloaded();
  const std::vector<PixelBox> windows = odd_windows(bytes);
  Detections in_windows;
  law(detector->detect(image, windows, in_windows) == Status::ok, "windows are searched");
  check(in_windows, image);
  for (const Detection& mark : in_windows) {
    law(std::any_of(windows.begin(), windows.end(),
                    [&](const PixelBox& box) { return has_centre_within(mark.outer, box.clipped_to(image)); }),
        "a mark lies in its window");
  }

  const std::vector<Expected> expected = odd_expectations(bytes, whole);
  Detections measured;
  law(detector->measure(image, expected, measured) == Status::ok, "expected marks are measured");
  check(measured, image);
  check_kinds(measured, options);
  law(measured.size() <= expected.size(), "no more than expected");

  law(detector->detect(other.view(), again) == Status::ok && equal(whole, again) &&
          detector->overloaded() == overloaded,
      "what lies between the rows, or came before, changes nothing");
  const auto fresh = std::make_unique<Detector>(options);
  law(fresh->measure(other.view(), expected, again) == Status::ok && equal(measured, again),
      "a measurement depends on the frame alone");
  return 0;
}
