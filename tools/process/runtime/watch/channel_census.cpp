#include "process/runtime/watch/channel_census.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/describe.hpp"
#include "link/channel_pattern.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {

std::vector<std::string> ChannelCensus::find_missing(const std::vector<InChannel>& wanted,
                                                     const std::string& prefix) const {
  std::vector<std::string> lines;
  for (const InChannel& channel : wanted) {
    const bus::ChannelPattern wanted_name(channel.name);
    const bool held_any = std::any_of(events_.begin(), events_.end(), [&](const auto& entry) {
      return wanted_name.matches(entry.first);
    });
    if (!channel.expected || held_any) continue;
    const std::string held = events_.empty() ? "no events at all" : io::list_channels(events_);
    std::string line = fmt::format("no event on {}; the log holds {}", channel.name, held);
    // If the log has no events at all, another channel name does not help.
    if (!events_.empty()) line += advise(channel.option, prefix);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string ChannelCensus::advise(const std::string& option, const std::string& prefix) const {
  if (prefix.empty()) return "; name the channel with " + option;
  const auto next = events_.lower_bound(prefix);
  if (next != events_.end() && next->first.starts_with(prefix)) {
    return fmt::format("; name the channel with {}, without {}", option, prefix);
  }
  return fmt::format("; none begins with {}: leave out --channel-prefix", prefix);
}

std::string ChannelCensus::find_taken(const std::vector<OutChannel>& wanted) const {
  std::string text;
  for (const OutChannel& channel : wanted) {
    for (const auto& [name, count] : events_) {
      if (!channel.holds(name)) continue;
      text += fmt::format("{}{} ({}; {})", text.empty() ? "" : ", ", printable(name), count,
                          channel.option);
    }
  }
  return text;
}

}  // namespace quadrille
