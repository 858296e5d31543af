#pragma once
/// @file  What is wrong with an input, and where: collected, so that one run tells everything.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace articam::modelgen {

enum class Severity { warning, error };

struct Message {
  Severity severity{};
  std::string file;     ///< as the user named it, or the option on the command line
  int line{};           ///< from 1; 0: the file as a whole
  std::string element;  ///< for example: joint 'door' <limit>
  std::string reason;   ///< with the remedy where there is one
};

/// How a message names an element: joint 'door'.
std::string title(std::string_view kind, std::string_view name);

/// `file:line: element: reason`. Anything that could steer a terminal is replaced by '?'.
std::string to_string(const Message& message);

class Diagnostics {
 public:
  /// A hostile file must not fill the memory with its errors; what comes later is only counted.
  static constexpr std::size_t kMaxMessages = 200;

  void error(std::string file, int line, std::string element, std::string reason);
  /// The input is taken; the reason says what was assumed.
  void warning(std::string file, int line, std::string element, std::string reason);

  void append(const Diagnostics& other);

  bool has_errors() const { return num_errors_ > 0; }
  const std::vector<Message>& messages() const { return messages_; }
  /// One message a line, ready for stderr.
  std::string text() const;

 private:
  void add(Message message);

  std::vector<Message> messages_;
  std::size_t num_errors_{};
  std::size_t num_dropped_{};
};

}  // namespace articam::modelgen
