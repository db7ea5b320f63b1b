#include "doctor/check_traffic.hpp"

#include <fmt/format.h>

#include <cmath>

#include "doctor/advise_channel.hpp"
#include "io/describe.hpp"
#include "link/channel_pattern.hpp"

namespace quadrille::doctor {
namespace {

std::string describe(const Stream& stream, double seconds) {
  return fmt::format("{} of up to {} bytes in {:g} s on {} from {}",
                     io::count_of(static_cast<std::size_t>(stream.messages), "cloud"),
                     stream.max_bytes, seconds, stream.channel, stream.sender);
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

Finding check_clouds(const Traffic& traffic, const std::string& cloud_channel, double seconds,
                     const std::string& prefix) {
  const bus::ChannelPattern wanted(cloud_channel);
  std::string here, elsewhere, channel;
  for (const Stream& stream : traffic.streams()) {
    if (stream.kind != Kind::kCloud) continue;
    if (wanted.matches(stream.channel)) {
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
          advise_channel("--in-channel", "--cloud-channel", channel, prefix)};
}

Finding check_losses(const Traffic& traffic, int port) {
  std::int64_t messages = 0, missing = 0, incomplete = 0;
  for (const auto& [name, sender] : traffic.senders()) {
    messages += sender.messages;
    missing += sender.missing;
    incomplete += sender.incomplete;
  }
  Finding finding{
      Verdict::kOk, "losses",
      fmt::format("{} of {}; {} missing, {} incomplete",
                  io::count_of(static_cast<std::size_t>(messages), "message"),
                  io::count_of(traffic.senders().size(), "sender"), missing, incomplete)};
  if (traffic.malformed() > 0) {
    finding.verdict = Verdict::kWarning;
    finding.what += fmt::format(
        "; {} not of LCM", io::count_of(static_cast<std::size_t>(traffic.malformed()), "datagram"));
    finding.remedy = fmt::format(
        "find who sends to this port: sudo tcpdump -ni any udp port {}; shut others out with "
        "--accept-from",
        port);
  }
  if (missing + incomplete == 0) return finding;
  finding.verdict = Verdict::kFailed;
  finding.remedy = "larger buffers (see buffers), fewer or smaller messages, or a faster network";
  return finding;
}

Findings check_clocks(const Traffic& traffic, std::int64_t now) {
  Findings findings;
  // Clocks before the day on which this check was written are wrong: a machine without a battery
  // starts in 1970.
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
