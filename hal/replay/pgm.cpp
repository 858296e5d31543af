#include "hal/replay/pgm.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

namespace articam::hal {
namespace {

// The text before the pixels: numbers parted by white space and comments that run from # to the end of a line.
class Header {
 public:
  explicit Header(std::string_view text) : text_{text} {}

  /// The next number, or -1 where there is none, or none below a million.
  int number() {
    skip_space();
    int value = -1;
    for (; at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])); ++at_) {
      value = (value < 0 ? 0 : value) * 10 + (text_[at_] - '0');
      if (value > 999'999) return -1;
    }
    return value;
  }
  /// Where the pixels begin: after the one white space that ends the header.
  bool end(std::size_t& pixels) const {
    pixels = at_ + 1;
    return at_ < text_.size() && is_space(text_[at_]);
  }

 private:
  static bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
  void skip_space() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] == '#')
        at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
      else
        ++at_;
    }
  }

  std::string_view text_;
  std::size_t at_{2};  // after the magic number
};

Status refuse(Status status, std::string reason, std::string& why) {
  why = std::move(reason);
  return status;
}

// The system's words for the last error, where it left any.
std::string system_reason(int error) {
  return error != 0 ? std::generic_category().message(error) : "input/output error";
}

Status parse_pgm(const std::string& bytes, GreyImage& out, std::string& why) {
  if (bytes.compare(0, 2, "P5") != 0)
    return refuse(Status::bad_argument, "not a binary PGM (it does not begin with P5)", why);
  Header header{bytes};
  const int width = header.number(), height = header.number(), maximum = header.number();
  std::size_t begin = 0;
  if (width <= 0 || height <= 0 || maximum <= 0 || !header.end(begin)) {
    return refuse(Status::bad_argument, "its header does not hold a width, a height and a maximum value", why);
  }
  if (width > kMaxImageWidth_px || height > kMaxImageHeight_px) {
    return refuse(Status::bad_argument,
                  std::to_string(width) + " x " + std::to_string(height) + " pixels, but at most " +
                      std::to_string(kMaxImageWidth_px) + " x " + std::to_string(kMaxImageHeight_px) + " are supported",
                  why);
  }
  if (maximum > 255)
    return refuse(Status::bad_argument,
                  "16-bit pixels (maximum value " + std::to_string(maximum) + "); only 8-bit are supported", why);
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (bytes.size() - begin < size) {
    return refuse(Status::bad_argument,
                  "cut short: " + std::to_string(bytes.size() - begin) + " of " + std::to_string(size) + " pixels",
                  why);
  }
  std::vector<std::uint8_t> pixels(bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                                   bytes.begin() + static_cast<std::ptrdiff_t>(begin + size));
  for (std::uint8_t& pixel : pixels) {
    if (pixel > maximum) return refuse(Status::bad_argument, "a pixel is above the maximum value of the header", why);
    pixel = static_cast<std::uint8_t>((pixel * 255 + maximum / 2) / maximum);
  }
  out = {width, height, std::move(pixels)};
  return Status::ok;
}

Status read_file(const std::filesystem::path& path, GreyImage& out, std::string& why) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return refuse(Status::io_error, "is a directory", why);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return refuse(Status::io_error, system_reason(errno), why);
  const std::string bytes{std::istreambuf_iterator<char>{file}, {}};
  if (file.bad()) return refuse(Status::io_error, system_reason(errno), why);
  return parse_pgm(bytes, out, why);
}

Status write_file(const std::filesystem::path& path, const ImageView& image, std::string& why) {
  if (!image.ok()) return refuse(Status::bad_argument, "no image to write", why);
  std::error_code error;
  const auto target = std::filesystem::symlink_status(path, error);
  if (std::filesystem::exists(target) && !std::filesystem::is_regular_file(target)) {
    return refuse(Status::io_error, "is a folder, a link or a device: only a plain file is replaced", why);
  }
  std::filesystem::path temporary = path;
  temporary += ".partial";
  errno = 0;
  std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
  file << "P5\n" << image.width_px << ' ' << image.height_px << "\n255\n";
  for (int v = 0; v < image.height_px; ++v) file.write(reinterpret_cast<const char*>(image.row(v)), image.width_px);
  file.close();
  std::string reason = system_reason(errno);
  if (file) {
    std::filesystem::rename(temporary, path, error);
    if (!error) return Status::ok;
    reason = error.message();
  }
  std::filesystem::remove(temporary, error);
  return refuse(Status::io_error, std::move(reason), why);
}

// Puts the file's name before the reason of a failure.
Status about(const std::filesystem::path& path, Status status, std::string& why) {
  if (status != Status::ok) why = path.string() + ": " + why;
  return status;
}

}  // namespace

Status read_pgm(const std::filesystem::path& path, GreyImage& out, std::string& why) {
  return about(path, read_file(path, out, why), why);
}

Status write_pgm(const std::filesystem::path& path, const ImageView& image, std::string& why) {
  return about(path, write_file(path, image, why), why);
}

}  // namespace articam::hal
