#include "tools/modelgen/source_file.hpp"

#include <sha256.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace articam::modelgen {
namespace {

/// Length of the well-formed UTF-8 sequence of several bytes at the front, 0 if there is none (RFC 3629, section 4).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto tail = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
  const unsigned lead = byte(0), second = byte(1);
  if (lead >= 0xC2 && lead <= 0xDF) return tail(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const bool overlong = lead == 0xE0 && second < 0xA0, surrogate = lead == 0xED && second > 0x9F;
    return tail(1) && tail(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const bool overlong = lead == 0xF0 && second < 0x90, beyond = lead == 0xF4 && second > 0x8F;
    return tail(1) && tail(2) && tail(3) && !overlong && !beyond ? 4 : 0;
  }
  return 0;
}

}  // namespace

std::size_t find_non_text(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto c = static_cast<unsigned char>(bytes[i]);
    const std::size_t length = c < 0x80 ? 1 : utf8_length(bytes.substr(i));  // nearly all of it is ASCII
    if (length == 0 || (c < 0x20 && c != '\t' && c != '\n' && c != '\r')) return i;
    i += length;
  }
  return std::string_view::npos;
}

std::string SourceFile::file_name() const { return std::filesystem::path(path).filename().string(); }

int SourceFile::line_of(std::size_t offset) const {
  return 1 + static_cast<int>(std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

std::optional<SourceFile> make_source(SourceFile source, Diagnostics& diagnostics) {
  const auto refuse = [&](int line, const std::string& reason) {
    diagnostics.error(source.path, line, "file", reason);
    return std::nullopt;
  };
  if (source.bytes.empty()) return refuse(0, "is empty");
  if (source.bytes.size() > kMaxSourceBytes) return refuse(0, "is larger than 1 MiB");
  const std::size_t bad = find_non_text(source.bytes);
  if (bad != std::string::npos) return refuse(source.line_of(bad), "is not UTF-8 text; save it in that encoding");
  return source;
}

std::optional<SourceFile> read_source(const std::string& path, Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& reason) {
    diagnostics.error(path, 0, "file", reason);
    return std::nullopt;
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return refuse("is a folder, not a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return refuse(std::string("cannot be opened: ") + std::strerror(errno));
  SourceFile source{path, ""};
  std::array<char, 1 << 14> part{};
  while (source.bytes.size() <= kMaxSourceBytes && stream.read(part.data(), part.size()).gcount() > 0) {
    source.bytes.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return refuse("cannot be read");
  return make_source(std::move(source), diagnostics);
}

std::string sha256(std::string_view bytes) {
  SHA256_CTX context;
  SHA256Init(&context);
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  std::array<char, SHA256_DIGEST_STRING_LENGTH> text{};
  SHA256End(&context, text.data());
  return text.data();
}

}  // namespace articam::modelgen
