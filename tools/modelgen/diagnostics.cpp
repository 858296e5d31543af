#include "tools/modelgen/diagnostics.hpp"

#include <fmt/format.h>

#include <utility>

namespace articam::modelgen {
namespace {
constexpr std::size_t kMaxLength = 1000;  // a quoted value may be as long as the file
}  // namespace

std::string title(std::string_view kind, std::string_view name) { return fmt::format("{} '{}'", kind, name); }

std::string to_string(const Message& message) {
  const std::string line = message.line > 0 ? fmt::format("{}:", message.line) : "";
  const char* const severity = message.severity == Severity::warning ? "warning: " : "";
  std::string text = fmt::format("{}:{} {}: {}{}", message.file, line, message.element, severity, message.reason);
  if (text.size() > kMaxLength) text.replace(kMaxLength, std::string::npos, " ...");
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

void Diagnostics::error(std::string file, int line, std::string element, std::string reason) {
  ++num_errors_;
  add({Severity::error, std::move(file), line, std::move(element), std::move(reason)});
}

void Diagnostics::warning(std::string file, int line, std::string element, std::string reason) {
  add({Severity::warning, std::move(file), line, std::move(element), std::move(reason)});
}

void Diagnostics::add(Message message) {
  if (messages_.size() == kMaxMessages) {
    ++num_dropped_;
  } else {
    messages_.push_back(std::move(message));
  }
}

void Diagnostics::append(const Diagnostics& other) {
  for (const Message& message : other.messages_) add(message);
  num_errors_ += other.num_errors_;
  num_dropped_ += other.num_dropped_;
}

std::string Diagnostics::text() const {
  std::string text;
  for (const Message& message : messages_) text += to_string(message) + '\n';
  if (num_dropped_ > 0) text += fmt::format("... and {} more\n", num_dropped_);
  return text;
}

}  // namespace articam::modelgen
