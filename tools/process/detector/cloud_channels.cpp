#include "process/detector/cloud_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "link/connection.hpp"
#include "process/detector/trackers.hpp"

namespace quadrille {
namespace {

// A channel without clouds for this long may be replaced by another one.
constexpr std::chrono::seconds kSilence{10};

}  // namespace

CloudChannels::CloudChannels(const DetectorSettings& settings)
    : settings_(settings), in_(settings.in_channel) {}

std::vector<OutChannel> CloudChannels::out_channels() const {
  std::vector<OutChannel> channels;
  DetectorSettings::visit_channels(
      settings_, [&](Way way, const char* option, const std::string& name, const char*) {
        const bool several = in_.is_pattern() && &name != &settings_.status_channel;
        if (way == Way::kOut) channels.push_back({option, name, several});
      });
  DetectorSettings::visit_viewer(settings_, [&](const std::string& name) {
    channels.push_back({"--viz", name});
  });
  return channels;
}

bool CloudChannels::matches(const std::string& channel) const {
  if (!in_.matches(channel)) return false;
  const std::vector<OutChannel> own = out_channels();
  return std::none_of(own.begin(), own.end(),
                      [&](const OutChannel& out) { return out.holds(channel); });
}

std::optional<bus::Rejection> CloudChannels::refuse(const std::string& channel, TimePoint now) {
  if (const auto known = known_.find(channel); known != known_.end()) {
    known->second = now;
    return std::nullopt;
  }
  if (known_.size() == Trackers::kMaxTrackers && !forget_silent(now)) {
    return bus::Rejection{bus::RejectReason::kBadChannel,
                          fmt::format("clouds of {} channels are taken already; start one process "
                                      "more, and give each a pattern of its own",
                                      known_.size())};
  }
  try {
    bus::check_channel(results_channel(settings_.out_channel, channel));
    bus::check_channel(results_channel(settings_.boxes_channel, channel));
    bus::check_channel(results_channel(settings_.bodies_channel, channel));
    bus::check_channel(results_channel(settings_.body_tracks_channel, channel));
  } catch (const std::invalid_argument& error) {
    return bus::Rejection{bus::RejectReason::kBadChannel, error.what()};
  }
  known_.emplace(channel, now);
  return std::nullopt;
}

/// Makes room for another channel; returns false if clouds have come on all of them lately.
bool CloudChannels::forget_silent(TimePoint now) {
  const auto oldest =
      std::min_element(known_.begin(), known_.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (now - oldest->second < kSilence) return false;
  known_.erase(oldest);
  return true;
}

std::string CloudChannels::results_channel(const std::string& name,
                                           const std::string& cloud_channel) const {
  if (!in_.is_pattern()) return name;
  // The result's name already begins with the prefix of all channels.
  const std::string& prefix = settings_.process.channel_prefix;
  const bool has_prefix = cloud_channel.starts_with(prefix);
  return name + "_" + (has_prefix ? cloud_channel.substr(prefix.size()) : cloud_channel);
}

}  // namespace quadrille
