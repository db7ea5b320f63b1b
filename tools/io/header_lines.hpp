#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::io {

/// Reads text that precedes or makes up a file's data, piece by piece.
class TextCursor {
 public:
  explicit TextCursor(std::span<const std::byte> bytes, std::size_t offset = 0);

  /// Number of bytes read so far.
  std::size_t offset() const { return offset_; }
  bool at_end() const { return offset_ >= text_.size(); }
  std::size_t remaining() const { return text_.size() - offset_; }

  /// Returns the next line without its end (LF or CRLF); nullopt at the end of the text.
  std::optional<std::string_view> next_line();
  /// Returns the next run of characters without white space; empty at the end of the text.
  std::string_view next_word();

 private:
  std::string_view text_;
  std::size_t offset_;
};

/// Splits a line into its words.
std::vector<std::string_view> split_words(std::string_view line);

/// Parses a whole word as a number; nullopt if it is none. Accepts nan, inf and a leading plus
/// sign.
std::optional<double> to_number(std::string_view word);

/// Parses a whole word as a count; nullopt if it is none or does not fit into 64 bits.
std::optional<std::uint64_t> to_count(std::string_view word);

}  // namespace quadrille::io
