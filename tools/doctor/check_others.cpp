#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "doctor/check_traffic.hpp"
#include "link/channel_pattern.hpp"

namespace quadrille::doctor {
namespace {

using Streams = std::vector<Stream>;

/// A kind of message that only one process should send, the option that names its channel, and what
/// it means if two do.
struct Worker {
  Kind kind;
  Verdict verdict;
  const char *what, *option;
};
// Two senders of clouds do not prevent answers, since the newest cloud wins.
constexpr Worker kWorkers[] = {
    {Kind::kCloud, Verdict::kWarning, "send clouds", ""},
    {Kind::kPose, Verdict::kWarning, "send poses", ""},
    {Kind::kQuadrics, Verdict::kFailed, "detectors answer", "--out-channel"},
    {Kind::kDetectorStatus, Verdict::kFailed, "detectors answer", "--status-channel"},
    {Kind::kGrasps, Verdict::kFailed, "planners answer", "--grasps-channel"},
    {Kind::kPlannerStatus, Verdict::kFailed, "planners answer", "--status-channel"}};

/// Processes that do the same work at the same time, and their channels.
struct Twins {
  const Worker* worker;
  std::set<std::string> senders, channels, options;
};

/// Returns the senders whose messages of a kind overlap in time. A sender that begins after another
/// has ended is a process that was restarted.
std::set<std::string> common_senders(const Streams& streams, Kind kind) {
  std::set<std::string> senders;
  for (const Stream& one : streams) {
    for (const Stream& other : streams) {
      const bool both = one.kind == kind && other.kind == kind && one.sender != other.sender;
      if (both && one.first <= other.last && other.first <= one.last) senders.insert(one.sender);
    }
  }
  return senders;
}

/// Two running detectors, or planners, publish on all of the same channels. Combines what was found
/// on these channels into one finding.
void add_twins(const std::string& channel, const Streams& streams, std::vector<Twins>* all) {
  for (const Worker& worker : kWorkers) {
    const auto senders = common_senders(streams, worker.kind);
    if (senders.empty()) continue;
    auto known = std::find_if(all->begin(), all->end(), [&](const Twins& twins) {
      return std::string(twins.worker->what) == worker.what && twins.senders == senders;
    });
    if (known == all->end()) known = all->insert(known, Twins{&worker, senders, {}, {}});
    known->channels.insert(channel);
    if (*worker.option != '\0') known->options.insert(worker.option);
  }
}

Finding describe(const Twins& twins) {
  std::string remedy =
      "sudo ss -uanp tells whose port that is; end all but one, or give each a channel of its own";
  if (!twins.options.empty()) {
    remedy += fmt::format(" with {}", fmt::join(twins.options, ", "));
  } else {
    remedy += "; --accept-from keeps strangers out";
  }
  return {twins.worker->verdict, "others",
          fmt::format("{} {} on {}: {}", twins.senders.size(), twins.worker->what,
                      fmt::join(twins.channels, ", "), fmt::join(twins.senders, ", ")),
          remedy};
}

void check_clash(const std::string& channel, const Streams& streams, Findings* findings) {
  std::set<std::int64_t> types;
  std::set<std::string> senders;
  for (const Stream& stream : streams) {
    // Clouds of several types may share a channel.
    types.insert(stream.kind == Kind::kCloud ? 0 : stream.fingerprint);
    senders.insert(stream.sender);
  }
  if (types.size() < 2) return;
  findings->push_back({Verdict::kFailed, "others",
                       fmt::format("messages of {} types on {}, from {}", types.size(), channel,
                                   fmt::join(senders, ", ")),
                       "give each type a channel of its own"});
}

/// Groups the streams by channel, keeping only our own channels and those on which clouds are
/// expected.
std::map<std::string, Streams> group_by_channel(const Traffic& traffic,
                                                const std::string& cloud_channel) {
  const bus::ChannelPattern clouds(cloud_channel);
  std::map<std::string, Streams> channels;
  for (const Stream& stream : traffic.streams()) channels[stream.channel].push_back(stream);
  std::erase_if(channels, [&](const auto& entry) {
    return !clouds.matches(entry.first) &&
           std::all_of(entry.second.begin(), entry.second.end(),
                       [](const Stream& stream) { return stream.kind == Kind::kOther; });
  });
  return channels;
}

}  // namespace

Findings check_others(const Traffic& traffic, const std::string& cloud_channel) {
  Findings findings;
  std::vector<Twins> all_twins;
  for (const auto& [channel, streams] : group_by_channel(traffic, cloud_channel)) {
    add_twins(channel, streams, &all_twins);
    check_clash(channel, streams, &findings);
  }
  for (const Twins& twins : all_twins) findings.push_back(describe(twins));
  if (findings.empty()) {
    findings.push_back({Verdict::kOk, "others", "no two senders or types share a channel"});
  }
  return findings;
}

}  // namespace quadrille::doctor
