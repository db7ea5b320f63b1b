#include "process/runtime/watch/silent_channels.hpp"

#include <fmt/format.h>

namespace quadrille {

SilentChannels::SilentChannels(const std::vector<InChannel>& channels, TimePoint start)
    : start_(start) {
  for (const InChannel& channel : channels) watched_.emplace_back().channel = channel;
}

std::vector<std::string> SilentChannels::find_warnings(TimePoint now) {
  std::vector<std::string> lines;
  if (now - start_ < kGrace) return lines;
  for (Watched& watched : watched_) {
    if (watched.told || watched.heard || !watched.channel.expected) continue;
    watched.told = true;
    lines.push_back(fmt::format(
        "nothing has come on {} yet; 'quadrille doctor' tells what does, and {} names another",
        watched.channel.name, watched.channel.option));
  }
  return lines;
}

}  // namespace quadrille
