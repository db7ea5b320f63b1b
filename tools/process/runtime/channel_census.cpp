#include "process/runtime/channel_census.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/describe.hpp"

namespace quadrille {
std::vector<std::string> ChannelCensus::find_missing(const std::vector<InChannel>& wanted) const {
  std::vector<std::string> lines;
  for (const InChannel& channel : wanted) {
    if (!channel.expected || events_.count(channel.name) > 0) continue;
    const std::string held = events_.empty() ? "no events at all" : io::list_channels(events_);
    std::string line = fmt::format("no event on {}; the log holds {}", channel.name, held);
    // Where there is nothing, another name helps no more.
    if (!events_.empty()) line += "; name the channel with " + channel.option;
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string ChannelCensus::find_taken(const std::vector<OutChannel>& wanted) const {
  std::string text;
  for (const OutChannel& channel : wanted) {
    const auto found = events_.find(channel.name);
    if (found == events_.end()) continue;
    text += fmt::format("{}{} ({}; {})", text.empty() ? "" : ", ", channel.name, found->second,
                        channel.option);
  }
  return text;
}

}  // namespace quadrille
