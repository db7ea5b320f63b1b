#include "io/header_lines.hpp"

#include <charconv>
#include <limits>

namespace quadrille::io {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

TextCursor::TextCursor(std::span<const std::byte> bytes, std::size_t offset)
    : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()), offset_(offset) {}

std::optional<std::string_view> TextCursor::next_line() {
  if (at_end()) return std::nullopt;
  const std::size_t end = text_.find('\n', offset_);
  const std::size_t stop = end == std::string_view::npos ? text_.size() : end;
  std::string_view line = text_.substr(offset_, stop - offset_);
  offset_ = end == std::string_view::npos ? stop : stop + 1;
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string_view TextCursor::next_word() {
  while (!at_end() && is_space(text_[offset_])) ++offset_;
  const std::size_t begin = offset_;
  while (!at_end() && !is_space(text_[offset_])) ++offset_;
  return text_.substr(begin, offset_ - begin);
}

std::vector<std::string_view> split_words(std::string_view line) {
  TextCursor cursor(std::as_bytes(std::span(line)));
  std::vector<std::string_view> words;
  for (auto word = cursor.next_word(); !word.empty(); word = cursor.next_word()) {
    words.push_back(word);
  }
  return words;
}

std::optional<double> to_number(std::string_view word) {
  if (word.size() > 1 && word.front() == '+') word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size()) return std::nullopt;
  // A number too small for a double counts as zero, and one too large as infinite.
  if (error == std::errc::result_out_of_range) {
    const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (error != std::errc()) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> to_count(std::string_view word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc() || end != word.data() + word.size()) {
    return std::nullopt;
  }
  return value;
}

}  // namespace quadrille::io
