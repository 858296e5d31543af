// The model compiler, the whole program: on a real file of 117 links beside parsing it alone, and on files made to
// hurt.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <tinyxml2.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "tests/support/hostile_models.hpp"

namespace articam {
namespace {

namespace fs = std::filesystem;

constexpr rlim_t kMemory_bytes = 64u << 20;
const fs::path kApartment = fs::path(ARTICAM_URDF_CORPUS) / "code-iai__iai_maps__apartment.urdf";

struct Cost {
  int exit_code{-1};
  double cpu_s{};     ///< user and system
  double peak_MiB{};  ///< resident; 0 where the kernel lets nobody look
};

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

/// Of a program that still runs. What wait4 tells would be no less than what this program itself keeps.
double peak_MiB(pid_t program) {
  std::ifstream status("/proc/" + std::to_string(program) + "/status");
  for (std::string word; status >> word;) {
    if (word != "VmHWM:") continue;
    double kibibytes = 0;
    status >> kibibytes;
    return kibibytes / 1024;
  }
  return 0;
}

fs::path own_file(const char* extension) {
  return fs::temp_directory_path() / ("articam_bench_" + std::to_string(::getpid()) + extension);
}

/// Runs articam-modelgen in silence, its address space limited to 64 MiB: with more it would fail, not only be slow.
Cost run_modelgen(const fs::path& urdf, const fs::path& markers = {}) {
  const fs::path header = own_file(".hpp");
  std::array<std::string, 9> words{ARTICAM_MODELGEN, "--urdf",    urdf,   "--name", "Bench", "-o",
                                   header,           "--markers", markers};
  std::array<char*, 10> arguments{};
  std::transform(words.begin(), words.end() - (markers.empty() ? 2 : 0), arguments.begin(),
                 [](std::string& word) { return word.data(); });
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit limit{kMemory_bytes, kMemory_bytes};
    const int null = ::open("/dev/null", O_WRONLY);
    ::dup2(null, STDERR_FILENO);
    ::ptrace(PTRACE_TRACEME);  // so that it can be looked at when it ends
    if (::setrlimit(RLIMIT_AS, &limit) == 0) ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  Cost cost;
  while (::wait4(child, &status, 0, &usage) == child && WIFSTOPPED(status)) {  // at its start, and at its end
    ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACEEXIT);
    cost.peak_MiB = peak_MiB(child);
    ::ptrace(PTRACE_CONT, child, nullptr, nullptr);
  }
  fs::remove(header);
  cost.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  cost.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  return cost;
}

std::string apartment() {
  std::ifstream stream(kApartment, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

double parse_s(const std::string& text) {
  const auto start = std::chrono::steady_clock::now();
  tinyxml2::XMLDocument document;
  benchmark::DoNotOptimize(document.Parse(text.data(), text.size()));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void floor_parse(benchmark::State& state) {
  const std::string text = apartment();
  if (text.empty()) return state.SkipWithError("no URDF corpus at ../shared/urdf_corpus");
  for (auto _ : state) benchmark::DoNotOptimize(parse_s(text));
}
BENCHMARK(floor_parse)->Name("floor/parse_apartment")->Unit(benchmark::kMillisecond);

/// `of_bound`: the least of all runs over three times the least time of parsing, and 5 ms.
void compile(benchmark::State& state) {
  const std::string text = apartment();
  if (text.empty()) return state.SkipWithError("no URDF corpus at ../shared/urdf_corpus");
  double parse = std::numeric_limits<double>::infinity(), least = parse, peak_MiB = 0;
  for (auto _ : state) {
    parse = std::min(parse, parse_s(text));
    const Cost cost = run_modelgen(kApartment);
    if (cost.exit_code != 0) return state.SkipWithError("articam-modelgen failed within 64 MiB");
    state.SetIterationTime(cost.cpu_s);
    least = std::min(least, cost.cpu_s);
    peak_MiB = std::max(peak_MiB, cost.peak_MiB);
  }
  state.counters = {{"least_ms", 1e3 * least}, {"of_bound", least / (3 * parse + 5e-3)}, {"peak_MiB", peak_MiB}};
}
BENCHMARK(compile)->Name("modelgen/apartment")->Unit(benchmark::kMillisecond)->UseManualTime();

void refuse(benchmark::State& state, const test::HostileModel& model) {
  const fs::path urdf = own_file(".urdf"), markers = own_file(".yaml");
  std::ofstream(urdf, std::ios::binary) << model.urdf;
  std::ofstream(markers, std::ios::binary) << model.markers;
  double most = 0, peak_MiB = 0;
  for (auto _ : state) {
    const Cost cost = run_modelgen(urdf, model.markers.empty() ? fs::path{} : markers);
    if (cost.exit_code != 1) {
      state.SkipWithError("was not refused within 64 MiB");
      break;
    }
    state.SetIterationTime(cost.cpu_s);
    most = std::max(most, cost.cpu_s);
    peak_MiB = std::max(peak_MiB, cost.peak_MiB);
  }
  fs::remove(urdf);
  fs::remove(markers);
  state.counters = {{"most_ms", 1e3 * most}, {"peak_MiB", peak_MiB}};
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const test::HostileModel& model : test::hostile_models()) {
    const auto run = [model](benchmark::State& state) { refuse(state, model); };
    benchmark::RegisterBenchmark((std::string("modelgen/hostile/") + model.name).c_str(), run)
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime();
  }
  return true;
}();

}  // namespace
}  // namespace articam
