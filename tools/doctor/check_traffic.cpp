#include "doctor/check_traffic.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

namespace quadrille::doctor {
namespace {

std::string describe(const Stream& stream, double seconds) {
  return fmt::format("{} clouds of up to {} bytes in {:g} s from {}", stream.messages,
                     stream.max_bytes, seconds, stream.sender);
}

/// What sends a kind of message, the name of its channel's option, and what to do about two.
struct Worker {
  Kind kind;
  const char *name, *option;
};
constexpr Worker kWorkers[] = {{Kind::kQuadrics, "detectors", "--out-channel"},
                               {Kind::kDetectorStatus, "detectors", "--status-channel"},
                               {Kind::kGrasps, "planners", "--grasps-channel"},
                               {Kind::kPlannerStatus, "planners", "--status-channel"}};

/// The senders on a channel that sent such messages during one common time. One that begins when
/// the other has ended is a process that was started anew.
std::set<std::string> common_senders(const std::vector<Stream>& streams, const std::string& channel,
                                     Kind kind) {
  std::set<std::string> senders;
  for (const Stream& one : streams) {
    for (const Stream& other : streams) {
      const bool both = one.channel == channel && other.channel == channel && one.kind == kind &&
                        other.kind == kind && one.sender != other.sender;
      if (both && one.first <= other.last && other.first <= one.last) senders.insert(one.sender);
    }
  }
  return senders;
}

void check_twins(const std::vector<Stream>& streams, const std::string& channel,
                 Findings* findings) {
  for (const Worker& worker : kWorkers) {
    const auto senders = common_senders(streams, channel, worker.kind);
    if (senders.empty()) continue;
    findings->push_back(
        {Verdict::kFailed, "others",
         fmt::format("{} {} answer on {}: {}", senders.size(), worker.name, channel,
                     fmt::join(senders, ", ")),
         fmt::format("sudo ss -uanp tells whose port that is; end all but one, or give each a "
                     "channel of its own with {}",
                     worker.option)});
  }
}

void check_clash(const std::vector<Stream>& streams, const std::string& channel,
                 Findings* findings) {
  std::set<std::int64_t> types;
  std::set<std::string> senders;
  for (const Stream& stream : streams) {
    if (stream.channel != channel) continue;
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

Finding describe_clock(const Stream& stream, double seconds_off) {
  constexpr double kLongAgo = 86400.0;
  const bool is_status =
      stream.kind == Kind::kDetectorStatus || stream.kind == Kind::kPlannerStatus;
  return {
      Verdict::kWarning, "clocks",
      fmt::format("{} from {}: utime is {:.1f} s {} this machine's clock", stream.channel,
                  stream.sender, std::abs(seconds_off), seconds_off < 0 ? "behind" : "ahead of"),
      seconds_off < -kLongAgo && !is_status
          ? "nothing if a log is played; else stamp clouds with microseconds since 1970"
          : "sudo timedatectl set-ntp true, on both machines"};
}

void check_clock(const Stream& stream, Findings* findings) {
  const std::string start = fmt::format("{} from {}: ", stream.channel, stream.sender);
  if (stream.zero_utimes > 1) {
    findings->push_back({Verdict::kWarning, "clocks",
                         fmt::format("{}{} of {} messages have utime 0", start, stream.zero_utimes,
                                     stream.messages),
                         "have the driver stamp each cloud with its time of capture"});
    return;
  }
  if (stream.kind == Kind::kCloud && stream.stale_utimes > 0) {
    findings->push_back({Verdict::kWarning, "clocks",
                         fmt::format("{}utime did not grow from {} of {} clouds to the next", start,
                                     stream.stale_utimes, stream.messages),
                         "one sender a channel, and a utime of its own for each cloud; nothing if "
                         "a log began anew"});
  }
  constexpr double kMaxOff = 1.0;
  const double off = 1e-6 * (static_cast<double>(stream.utime) - static_cast<double>(stream.last));
  const bool tells = stream.kind == Kind::kCloud || stream.kind == Kind::kDetectorStatus ||
                     stream.kind == Kind::kPlannerStatus;
  if (tells && std::abs(off) > kMaxOff) findings->push_back(describe_clock(stream, off));
}

}  // namespace

Finding check_clouds(const Traffic& traffic, const std::string& cloud_channel, double seconds) {
  std::string here, elsewhere, channel;
  for (const Stream& stream : traffic.streams()) {
    if (stream.kind != Kind::kCloud) continue;
    if (stream.channel == cloud_channel) {
      here += fmt::format("{}{}", here.empty() ? "" : "; ", describe(stream, seconds));
    } else {
      channel = stream.channel;
      elsewhere += fmt::format("{}{}", elsewhere.empty() ? "" : ", ", channel);
    }
  }
  if (!here.empty()) return {Verdict::kOk, "clouds", here};
  if (elsewhere.empty()) {
    return {Verdict::kWarning, "clouds", fmt::format("nobody sent one in {:g} s", seconds),
            "start the camera's driver, or lcm-logplayer; --seconds listens longer"};
  }
  return {Verdict::kFailed, "clouds",
          fmt::format("none on {}, but some on {}", cloud_channel, elsewhere),
          fmt::format("quadrille-detector --in-channel {0}, quadrille-grasp-planner "
                      "--cloud-channel {0}",
                      channel)};
}

Finding check_losses(const Traffic& traffic) {
  std::int64_t messages = 0, missing = 0, incomplete = 0;
  for (const auto& [name, sender] : traffic.senders()) {
    messages += sender.messages;
    missing += sender.missing;
    incomplete += sender.incomplete;
  }
  Finding finding{Verdict::kOk, "losses",
                  fmt::format("{} messages of {} senders; {} missing, {} incomplete", messages,
                              traffic.senders().size(), missing, incomplete)};
  if (traffic.malformed() > 0) {
    finding.verdict = Verdict::kWarning;
    finding.what += fmt::format("; {} datagrams that are not LCM's", traffic.malformed());
    finding.remedy =
        "find who sends to this port: sudo tcpdump -ni any udp port 7667; shut others "
        "out with --accept-from";
  }
  if (missing + incomplete == 0) return finding;
  finding.verdict = Verdict::kFailed;
  finding.remedy = "larger buffers (see buffers), fewer or smaller messages, or a faster network";
  return finding;
}

Findings check_others(const Traffic& traffic, const std::string& cloud_channel) {
  Findings findings;
  const auto streams = traffic.streams();
  std::set<std::string> channels = {cloud_channel};
  for (const Stream& stream : streams) {
    if (stream.kind != Kind::kOther) channels.insert(stream.channel);
  }
  for (const std::string& channel : channels) {
    check_twins(streams, channel, &findings);
    check_clash(streams, channel, &findings);
  }
  if (findings.empty()) {
    findings.push_back(
        {Verdict::kOk, "others", "no two detectors, planners or types share a channel"});
  }
  return findings;
}

Findings check_clocks(const Traffic& traffic, std::int64_t now) {
  Findings findings;
  // The day on which this check was written: a machine without a battery begins with 1970.
  constexpr std::int64_t kEarliest = 1'700'000'000'000'000;
  if (now < kEarliest) {
    findings.push_back({Verdict::kFailed, "clocks", "this machine's clock is years behind",
                        "sudo timedatectl set-ntp true, or sudo date -s TIME"});
  }
  for (const Stream& stream : traffic.streams()) check_clock(stream, &findings);
  if (findings.empty()) {
    findings.push_back({Verdict::kOk, "clocks", "no message is more than 1 s off this machine's"});
  }
  return findings;
}

}  // namespace quadrille::doctor
