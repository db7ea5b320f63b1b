#pragma once

#include <regex>
#include <string>

#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Returns the regular expression that matches exactly a text.
QUADRILLE_EXPORT std::string pattern_of(const std::string& text);

/// The name of a channel, or a pattern of names. A text with a character that no name may have is a
/// regular expression, which must match the whole name. A dot is allowed in names and so makes no
/// pattern.
class ChannelPattern {
 public:
  /// @throws std::invalid_argument if the text is neither a valid name (see check_channel()) nor a
  ///   regular expression of at most 255 characters
  QUADRILLE_EXPORT explicit ChannelPattern(const std::string& text);

  const std::string& text() const { return text_; }
  bool is_pattern() const { return is_pattern_; }
  QUADRILLE_EXPORT bool matches(const std::string& channel) const;

 private:
  std::string text_;
  bool is_pattern_;
  std::regex regex_;
};

}  // namespace quadrille::bus
