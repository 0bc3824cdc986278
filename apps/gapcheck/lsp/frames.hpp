#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace gapcheck::app::lsp {

/// The largest message that is read: a deck of half a gigabyte with its escapes. A longer one is passed over.
inline constexpr std::size_t largest_message = std::size_t{1} << 30;
inline constexpr std::size_t longest_header = 4096;

/// What came in.
struct Frame {
  enum class Kind : std::uint8_t {
    message,
    refused,  ///< `text` says why; the next message can be read
    broken,   ///< `text` says why; nothing more can be told from the stream
    end,
  } kind = Kind::end;
  std::string text;
};

/// Reads messages with their Content-Length from a descriptor.
class FrameReader {
 public:
  explicit FrameReader(int descriptor, std::size_t largest = largest_message)
      : descriptor_(descriptor), largest_(largest) {}
  /// Waits for the next message.
  [[nodiscard]] Frame next();

 private:
  enum class Line : std::uint8_t { read, too_long, end };
  [[nodiscard]] bool fill();
  [[nodiscard]] Line read_line(std::string& line);
  [[nodiscard]] bool read_body(std::size_t length, std::string* body);
  int descriptor_;
  std::size_t largest_;
  std::string buffer_;
  std::size_t used_ = 0;
};

/// Gives a pipe more room, so that large messages come in fewer pieces; nothing for anything else.
void enlarge_pipe(int descriptor);

/// Writes one message. False: nobody reads any more.
[[nodiscard]] bool write_frame(int descriptor, std::string_view message);

}  // namespace gapcheck::app::lsp
