#include "link/channel_pattern.hpp"

#include <algorithm>
#include <stdexcept>

#include "quadrille/detector/printable.hpp"

namespace quadrille::bus {
namespace {

// Largest length of a pattern, and of a channel name to match; a log may contain longer names.
constexpr std::size_t kMaxBytes = 255;

bool has_operators(const std::string& text) {
  return text.find_first_of("*+?[](){}|\\^$") != std::string::npos;
}

}  // namespace

void check_channel(const std::string& channel) {
  const bool fit = std::all_of(channel.begin(), channel.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.' || c == '/';
  });
  if (channel.empty() || channel.size() > 63 || !fit) {
    throw std::invalid_argument("channel '" + printable(channel) +
                                "': must have 1 to 63 characters of A-Z a-z 0-9 _ - . /");
  }
}

std::string pattern_of(const std::string& text) {
  std::string pattern;
  for (const char c : text) {
    if (c == '.' || has_operators(std::string(1, c))) pattern += '\\';
    pattern += c;
  }
  return pattern;
}

ChannelPattern::ChannelPattern(const std::string& text)
    : text_(text), is_pattern_(has_operators(text)) {
  if (!is_pattern_) {
    check_channel(text);
    return;
  }
  if (text.size() > kMaxBytes) {
    throw std::invalid_argument("a pattern of " + std::to_string(text.size()) +
                                " characters; give at most " + std::to_string(kMaxBytes));
  }
  try {
    regex_.assign(text);
  } catch (const std::regex_error&) {
    throw std::invalid_argument("'" + printable(text) + "' is no regular expression of ECMAScript");
  }
}

bool ChannelPattern::matches(const std::string& channel) const {
  if (!is_pattern_) return channel == text_;
  return channel.size() <= kMaxBytes && std::regex_match(channel, regex_);
}

}  // namespace quadrille::bus
