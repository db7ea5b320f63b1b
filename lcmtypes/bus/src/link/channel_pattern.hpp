#pragma once

#include <regex>
#include <string>

namespace quadrille::bus {

/// Refuses channel names that LCM would truncate or read as a pattern.
/// @throws std::invalid_argument if the name does not consist of 1 to 63 of A-Z a-z 0-9 _ - . /
void check_channel(const std::string& channel);

/// Returns the regular expression that matches exactly a text.
std::string pattern_of(const std::string& text);

/// The name of a channel, or a pattern of names. A text with a character that no name may have is a
/// regular expression, which must match the whole name. A dot is allowed in names and so makes no
/// pattern.
class ChannelPattern {
 public:
  /// @throws std::invalid_argument if the text is neither a valid name (see check_channel()) nor a
  ///   regular expression of at most 255 characters
  explicit ChannelPattern(const std::string& text);

  const std::string& text() const { return text_; }
  bool is_pattern() const { return is_pattern_; }
  bool matches(const std::string& channel) const;

 private:
  std::string text_;
  bool is_pattern_;
  std::regex regex_;
};

}  // namespace quadrille::bus
