#include "tools/listen/statistics.hpp"

#include <fmt/format.h>

#include <numeric>
#include <string_view>

namespace articam::listen {
namespace {

double loss_percent(const Counts& counts) {
  const std::uint64_t sent = counts.received + counts.lost;
  return sent == 0 ? 0 : 100 * static_cast<double>(counts.lost) / static_cast<double>(sent);
}

std::string latency_row(std::string_view name, const Spread& times, std::string_view remark) {
  if (times.size() == 0) return fmt::format("{:<18}{:>9} {:>9} {:>9} {:>9}\n", name, "-", "-", "-", "-");
  return fmt::format("{:<18}{:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f}   {}\n", name, 1e3 * times.min(),
                     1e3 * times.quantile(0.5), 1e3 * times.quantile(0.99), 1e3 * times.max(), remark);
}

std::string bad_by_reason(const Statistics& statistics) {
  std::string text;
  const auto add = [&](std::string_view name, std::uint64_t count) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? ": " : ", ", name, count);
  };
  for (std::size_t i = 0; i < statistics.faults.size(); ++i)
    add(name(static_cast<wire::Fault>(i)), statistics.faults[i]);
  add("broken_frame", statistics.broken_frames);
  return text;
}

}  // namespace

std::uint64_t Statistics::bad() const { return std::accumulate(faults.begin(), faults.end(), broken_frames); }

std::string table(const Statistics& s) {
  std::string text = fmt::format("received    {}\n", s.estimates.received);
  text += fmt::format("lost        {} ({:.3f} %)\n", s.estimates.lost, loss_percent(s.estimates));
  text += fmt::format("duplicates  {}\n", s.estimates.duplicates);
  text += fmt::format("reordered   {}\n", s.estimates.reordered);
  text += fmt::format("bad         {}{}\n", s.bad(), bad_by_reason(s));
  text += fmt::format("sessions    {}\n", s.sessions);
  if (s.unnamed > 0) text += fmt::format("unnamed     {}: no packet with the names of their joints came\n", s.unnamed);
  text += fmt::format("{:<18}{:>9} {:>9} {:>9} {:>9}\n", "latency, ms", "min", "median", "99 %", "max");
  text += latency_row("capture -> send", s.capture_to_send, "board's clock");
  text += latency_row("send -> receipt", s.send_to_receipt,
                      s.exact ? "one machine, one clock" : "beyond the quickest packet of the last minute: two clocks");
  return text;
}

std::string status_line(const Statistics& s) {
  return fmt::format(
      "received {}  lost {} ({:.2f} %)  duplicates {}  reordered {}  bad {}  "
      "median ms: capture -> send {:.3f}, send -> receipt {:.3f}\n",
      s.estimates.received, s.estimates.lost, loss_percent(s.estimates), s.estimates.duplicates, s.estimates.reordered,
      s.bad(), 1e3 * s.capture_to_send.quantile(0.5), 1e3 * s.send_to_receipt.quantile(0.5));
}

}  // namespace articam::listen
