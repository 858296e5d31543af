/// @file  One mark that is not where its marker is: what it does to the estimate, and whether the estimate says so.

#include <memory>
#include <numbers>

#include "tests/bench/estimator_table/printer_tracker.hpp"
#include "tests/bench/estimator_table/table.hpp"

namespace articam::estimator_table {
namespace {

constexpr double kNoise_px = 0.02;

/// 5 to 100 px away, in any direction.
void push_off(Image& image, double least_px, double most_px, test::Random& random) {
  const double by_px = random.uniform(least_px, most_px), angle = random.uniform(-std::numbers::pi, std::numbers::pi);
  image[0] += by_px * std::cos(angle), image[1] += by_px * std::sin(angle);
}

std::size_t any_of(std::size_t count, test::Random& random) {
  return static_cast<std::size_t>(random.uniform(0, static_cast<double>(count)));
}

/// A tracker that has looked at the printer at rest for 20 s.
struct Watching {
  static constexpr int kFrames = 600;
  PrinterConfiguration truth = nominal<Printer>();
  Images images = images_of<Printer>(truth);
  Noise noise;
  PrinterTracker tracker{sim::PaperScenario::camera(), without_floor()};

  Watching(const Noise& of_marks, std::uint64_t seed) : noise{of_marks} {
    test::Random random{seed};
    for (int frame = 0; frame < kFrames; ++frame) {
      (void)tracker.step(detections_of(observe(images, noise, random), noise), {}, time_of(frame));
    }
  }
  PrinterEstimate next(PrinterTracker& copy, const Images& seen, Mask mask = kAll) const {
    copy = tracker;
    return copy.step(detections_of(seen, noise, mask), {}, time_of(kFrames));
  }
  Vec8 error(const PrinterEstimate& estimate) const { return model::difference<Printer, double>(truth, estimate.q); }
};

void compare(Table& table, const std::string& what, const RootMeanSquare& with, const RootMeanSquare& without) {
  const Vec8 ratio = with.value().cwiseQuotient(without.value());
  table.row(what, "1.3", fmt::format("{:.3f}", ratio.maxCoeff()), ratio.maxCoeff() <= 1.3);
}

void base_marker_off(const Run& run, Table& table, const Watching& watching) {
  const auto copy = std::make_unique<PrinterTracker>(watching.tracker);
  test::Random random{run.seed + 1};
  RootMeanSquare with, without;
  int unnoticed = 0;
  for (int trial = 0; trial < run.part(10000); ++trial) {
    const Images seen = observe(watching.images, watching.noise, random);
    const std::size_t liar = any_of(kBaseMarks, random);
    without.add(watching.error(watching.next(*copy, seen, kAll & ~(1u << liar))));
    Images off = seen;
    push_off(off[liar], 5, 100, random);
    with.add(watching.error(watching.next(*copy, off)));
    unnoticed += copy->matches()[liar].matched ? 1 : 0;
  }
  const std::string shapes = watching.noise.shape_px > 0 ? "centres and shapes" : "centres";
  compare(table, fmt::format("tracker, {}: a base marker off by 5-100 px, RMS / without it, most of 8", shapes), with,
          without);
  table.tell("of these, kept as a match", fmt::format("{:.2f} %", 100.0 * unnoticed / with.count()));
}

/// What a tracker expects of the next frame after a second at rest.
tracker::Prior<Printer, double> expectation(const Watching& watching, std::uint64_t seed) {
  test::Random random{seed};
  tracker::MotionPrior<Printer, double> motion{tracker::Options{}};
  motion.start(watching.truth);
  for (int frame = 0; frame <= 30; ++frame) {
    (void)motion.advance(time_of(frame));
    if (frame == 30) break;
    const auto solution = tracker::solve<Printer, double>(
        matches_of<Printer, double>(observe(watching.images, watching.noise, random), watching.noise), motion.prior(),
        motion.q(), 12);
    motion.measured(solution.q, solution.covariance, frame > 0);
  }
  return motion.prior();
}

/// A tracker takes marks for markers by where they are; two markers swapped are a matter of the solver.
void swapped_and_off_as_matches(const Run& run, Table& table, const Watching& watching) {
  const auto prior = expectation(watching, run.seed);
  test::Random random{run.seed + 2};
  for (const bool swapped : {false, true}) {
    RootMeanSquare with, without;
    for (int trial = 0; trial < run.part(10000); ++trial) {
      Images seen = observe(watching.images, watching.noise, random);
      const std::size_t first = any_of(kBaseMarks, random), second = (first + 1 + any_of(3, random)) % kBaseMarks;
      auto others =
          matches_of<Printer, double>(seen, watching.noise, kAll & ~(1u << first) & ~(swapped ? 1u << second : 0u));
      without.add(model::difference<Printer, double>(watching.truth,
                                                     tracker::solve<Printer, double>(others, prior, prior.mean, 12).q));
      if (swapped) {
        std::swap(seen[first], seen[second]);
      } else {
        push_off(seen[first], 5, 100, random);
      }
      auto matches = matches_of<Printer, double>(seen, watching.noise);
      const auto found = tracker::solve_with_consensus<Printer, double>(matches, prior, prior.mean, 12);
      with.add(model::difference<Printer, double>(watching.truth, found.solution.q));
    }
    compare(table,
            swapped ? "matches, centres: two base markers swapped, RMS / without them, most of 8"
                    : "matches, centres: a base marker off by 5-100 px, RMS / without it, most of 8",
            with, without);
  }
}

/// Where neither prior nor size speak against the mark, nothing can tell; then the joints are to be called weak.
void drawer_marker_off(const Run& run, Table& table, const Watching& watching, double least_px, double most_px) {
  using tracker::Observability;
  const auto copy = std::make_unique<PrinterTracker>(watching.tracker);
  test::Random random{run.seed + 3};
  const int trials = run.part(10000);
  int rejected = 0, weak = 0, inside = 0, inside_rejected = 0;
  for (int trial = 0; trial < trials; ++trial) {
    Images seen = observe(watching.images, watching.noise, random);
    const std::size_t liar = kBaseMarks + any_of(kMarks - kBaseMarks, random);
    push_off(seen[liar], least_px, most_px, random);
    const auto estimate = watching.next(*copy, seen);
    const Vec8 error = watching.error(estimate);
    bool good = true;
    for (int i = 6; i < kDof; ++i) good = good && error[i] * error[i] <= 9 * estimate.covariance(i, i);
    if (!copy->matches()[liar].matched) {
      ++rejected, inside_rejected += good ? 1 : 0;
    } else {
      const auto& seen_as = estimate.observability;
      weak += seen_as[6] != Observability::observed || seen_as[7] != Observability::observed ? 1 : 0;
      inside += good ? 1 : 0;
    }
  }
  const std::string what =
      fmt::format("tracker, {}: a drawer marker off by {}-{} px",
                  watching.noise.shape_px > 0 ? "centres and shapes" : "centres", least_px, most_px);
  const auto percent = [](int part, int whole) { return whole > 0 ? 100.0 * part / whole : 100.0; };
  const int kept = trials - rejected;
  table.row(what + ": rejected or reported weak", "100 %",
            fmt::format("{:.2f} % (rejected {:.2f} %)", percent(rejected + weak, trials), percent(rejected, trials)),
            rejected + weak == trials);
  table.row(what + ": kept, both joints inside 3 sigma", "99 %",
            fmt::format("{:.2f} % of {}", percent(inside, kept), kept), percent(inside, kept) >= 99);
  table.row(what + ": rejected, both joints inside 3 sigma", "99 %",
            fmt::format("{:.2f} % of {}", percent(inside_rejected, rejected), rejected),
            percent(inside_rejected, rejected) >= 99);
}

/// A drawer marker that has come off and stays there for a second: what its joint is called afterwards.
void drawer_marker_gone(const Run& run, Table& table, const Watching& watching) {
  using tracker::Observability;
  constexpr int kFrames = 30;
  const auto copy = std::make_unique<PrinterTracker>(watching.tracker);
  test::Random random{run.seed + 4};
  const int trials = run.part(1000);
  int trusted = 0, inside = 0;
  for (int trial = 0; trial < trials; ++trial) {
    *copy = watching.tracker;
    Images moved = watching.images;
    push_off(moved[kBaseMarks + any_of(kMarks - kBaseMarks, random)], 5, 100, random);
    PrinterEstimate estimate;
    for (int frame = 0; frame < kFrames; ++frame) {
      const auto marks = detections_of(observe(moved, watching.noise, random), watching.noise);
      estimate = copy->step(marks, {}, time_of(Watching::kFrames + frame));
    }
    const Vec8 error = watching.error(estimate);
    const auto& seen_as = estimate.observability;
    trusted += seen_as[6] == Observability::observed && seen_as[7] == Observability::observed ? 1 : 0;
    inside +=
        error[6] * error[6] <= 9 * estimate.covariance(6, 6) && error[7] * error[7] <= 9 * estimate.covariance(7, 7)
            ? 1
            : 0;
  }
  table.tell("tracker: a drawer marker off by 5-100 px for a second: both joints called observed, both inside 3 sigma",
             fmt::format("{:.1f} %, {:.1f} %", 100.0 * trusted / trials, 100.0 * inside / trials));
}

}  // namespace

void outliers(const Run& run, Table& table) {
  for (const double shape_px : {0.0, kNoise_px}) {
    run.progress(shape_px > 0 ? "centres and shapes" : "centres");
    const auto watching = std::make_unique<Watching>(Noise{kNoise_px, shape_px}, run.seed);
    base_marker_off(run, table, *watching);
    if (shape_px <= 0) swapped_and_off_as_matches(run, table, *watching);
    drawer_marker_off(run, table, *watching, 5, 16);
    drawer_marker_off(run, table, *watching, 16, 100);
    drawer_marker_gone(run, table, *watching);
  }
}

}  // namespace articam::estimator_table
