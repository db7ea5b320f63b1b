#include "process/runtime/channel_census.hpp"

#include <fmt/format.h>

#include <utility>

namespace quadrille {
namespace {

std::string list(const std::map<std::string, std::int64_t>& events) {
  if (events.empty()) return "no events at all";
  constexpr std::size_t kShown = 12;
  std::string text;
  std::size_t shown = 0;
  for (const auto& [channel, count] : events) {
    if (shown == kShown) return fmt::format("{} and {} more", text, events.size() - shown);
    text += fmt::format("{}{} ({})", shown++ == 0 ? "" : ", ", channel, count);
  }
  return text;
}

}  // namespace

std::vector<std::string> ChannelCensus::find_missing(const std::vector<InChannel>& wanted) const {
  std::vector<std::string> lines;
  for (const InChannel& channel : wanted) {
    if (!channel.expected || events_.count(channel.name) > 0) continue;
    std::string line = fmt::format("no event on {}; the log holds {}", channel.name, list(events_));
    // Where there is nothing, another name helps no more.
    if (!events_.empty()) line += "; name the channel with " + channel.option;
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace quadrille
