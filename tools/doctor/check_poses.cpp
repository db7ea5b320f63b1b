#include "doctor/check_poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "doctor/advise_channel.hpp"
#include "io/describe.hpp"
#include "poses/pose_history.hpp"
#include "quadrille/detector/tracker.hpp"

namespace quadrille::doctor {
namespace {

constexpr double kMsPerSecond = 1e3;
// Poses at this rate suffice for a camera on an arm [Hz].
constexpr double kGoodRate = 30.0;

Finding tell(Verdict verdict, std::string what, std::string remedy = "") {
  return {verdict, kPoseCheck, std::move(what), std::move(remedy)};
}

std::string count_poses(std::size_t count) { return io::count_of(count, "pose"); }

/// Returns the mean rate of arrival [Hz]; 0 if it is not known.
double rate_of(const std::deque<Arrival>& arrivals) {
  if (arrivals.size() < 2) return 0.0;
  const double seconds = seconds_between(arrivals.front().at, arrivals.back().at);
  return seconds > 0.0 ? static_cast<double>(arrivals.size() - 1) / seconds : 0.0;
}

/// Returns the middle one of some values, of which there is at least one.
double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Finding describe_absence(const PoseArrivals& heard, const std::string& prefix) {
  if (heard.other_channels.empty()) {
    return tell(Verdict::kFailed,
                fmt::format("nobody sent one on {} in {:.1f} s", heard.channel,
                            seconds_between(heard.begin, heard.end)),
                "start what sends the camera's poses, or lcm-logplayer; for a camera at rest give "
                "both processes --camera-pose instead of --pose-channel");
  }
  return tell(
      Verdict::kFailed,
      fmt::format("none on {}, but some on {}", heard.channel,
                  fmt::join(heard.other_channels, ", ")),
      advise_channel("--pose-channel", "--pose-channel", *heard.other_channels.begin(), prefix));
}

Finding describe_refusals(const PoseArrivals& heard) {
  const bool is_value = heard.refusal.reason == bus::RejectReason::kBadValue;
  return tell(Verdict::kFailed,
              fmt::format("{} of {} messages on {} are no valid poses: {}", heard.refused,
                          heard.refused + static_cast<std::int64_t>(heard.poses.size()),
                          heard.channel, heard.refusal.detail),
              is_value ? "have the sender write finite numbers, and the orientation as a "
                         "quaternion w, x, y, z of norm 1"
                       : "send bot_core.pose_t on it, and nothing else");
}

/// Tells whether poses have stopped: the last one is longer ago than a cloud may be from a pose,
/// and than slow poses are from each other.
bool have_stopped(const PoseArrivals& heard) {
  const double rate = rate_of(heard.poses);
  constexpr double kMissed = 3.0;
  const double usual = rate > 0.0 ? kMissed / rate : 0.0;
  return seconds_between(heard.poses.back().at, heard.end) >
         std::max(TrackOptions{}.pose_age, usual);
}

Finding describe_stop(const PoseArrivals& heard) {
  const std::int64_t last = heard.poses.back().at;
  const auto after = std::count_if(heard.clouds.begin(), heard.clouds.end(),
                                   [&](const Arrival& cloud) { return cloud.at > last; });
  std::string what = fmt::format("the last one on {} came {:.1f} s before the end of listening",
                                 heard.channel, seconds_between(last, heard.end));
  if (after > 0) what += fmt::format("; {} of {} clouds came after it", after, heard.clouds.size());
  return tell(Verdict::kFailed, what, "start what sends the camera's poses, or the log, again");
}

/// Returns by how much the clock of the poses is ahead of that of the clouds, from each cloud and
/// the first pose that arrives after it [s]; 0 if no pose and cloud arrive together.
double clock_difference(const PoseArrivals& heard) {
  constexpr double kTogether = 1.0;
  std::vector<double> differences;
  for (const Arrival& cloud : heard.clouds) {
    auto pose = std::lower_bound(heard.poses.begin(), heard.poses.end(), cloud.at,
                                 [](const Arrival& one, std::int64_t at) { return one.at < at; });
    if (pose == heard.poses.end()) --pose;
    const double later = seconds_between(cloud.at, pose->at);
    if (std::abs(later) > kTogether) continue;
    differences.push_back(seconds_between(cloud.utime, pose->utime) - later);
  }
  return differences.empty() ? 0.0 : median_of(std::move(differences));
}

Finding describe_clocks(const PoseArrivals& heard, double difference) {
  constexpr double kLongAgo = 86400.0;
  return tell(
      Verdict::kFailed,
      fmt::format("utime on {} is {:.1f} s {} that of clouds that come at the same time",
                  heard.channel, std::abs(difference), difference < 0.0 ? "behind" : "ahead of"),
      std::abs(difference) > kLongAgo
          ? "stamp clouds and poses by one clock, with microseconds since 1970"
          : "sudo timedatectl set-ntp true, on both machines; if their clocks agree, make "
            "the driver that is behind send sooner");
}

/// Returns how long each cloud waited for the first pose that is not older [s]. A cloud without
/// such a pose still waits at the end; it is left out if poses have stopped. Clouds older than all
/// poses are left out too, because the pose before them may have come before anyone listened.
std::vector<double> waits_of(const PoseArrivals& heard, bool stopped) {
  std::vector<Arrival> poses(heard.poses.begin(), heard.poses.end());
  std::sort(poses.begin(), poses.end(),
            [](const Arrival& one, const Arrival& other) { return one.utime < other.utime; });
  // Then the arrival at each pose is that of the first to arrive of it and all newer ones.
  for (std::size_t i = poses.size(); i-- > 1;) {
    poses[i - 1].at = std::min(poses[i - 1].at, poses[i].at);
  }
  std::vector<double> waits;
  for (const Arrival& cloud : heard.clouds) {
    const auto after = std::lower_bound(
        poses.begin(), poses.end(), cloud.utime,
        [](const Arrival& pose, std::int64_t utime) { return pose.utime < utime; });
    if (after == poses.begin() && after->utime > cloud.utime) continue;
    const bool came = after != poses.end();
    const double wait = seconds_between(cloud.at, came ? after->at : heard.end);
    if (came || (!stopped && wait > TrackOptions{}.pose_wait)) waits.push_back(std::max(wait, 0.0));
  }
  return waits;
}

/// Returns a wait with a margin over the longest one, in steps of 0.05 s.
std::string advise_wait(double longest) {
  // The largest value of track.pose_wait, and a step of the advice [s].
  constexpr double kMaxWait = 10.0, kStep = 0.05, kMargin = 1.25;
  constexpr double kRounding = 1e-9;
  const double wait = kStep * std::ceil(kMargin * longest / kStep - kRounding);
  if (wait > kMaxWait) return "send poses without such breaks";
  return fmt::format(
      "raise track.pose_wait to {:g} (under [track] in --config FILE of both processes), or send "
      "poses faster",
      wait);
}

void check_waits(const std::vector<double>& waits, Findings* findings) {
  const double most = TrackOptions{}.pose_wait;
  const auto late =
      std::count_if(waits.begin(), waits.end(), [&](double wait) { return wait > most; });
  if (late == 0) return;
  const double longest = *std::max_element(waits.begin(), waits.end());
  findings->push_back(
      tell(Verdict::kWarning,
           fmt::format("the pose after {} of {} clouds came more than track.pose_wait = {:g} s "
                       "later than the cloud, up to {:.3g} s",
                       late, waits.size(), most, longest),
           advise_wait(longest)));
}

std::string advise_rate(const PoseArrivals& heard) {
  // A rate that is measured exceeds a whole number by rounding.
  constexpr double kRounding = 0.1;
  const double clouds = std::ceil(rate_of(heard.clouds) - kRounding);
  return fmt::format("send poses at {:g} Hz or faster", std::max(kGoodRate, clouds));
}

/// Checks that the times of successive poses are not too far apart.
void check_gaps(const PoseArrivals& heard, Findings* findings) {
  double longest = 0.0;
  for (std::size_t i = 1; i < heard.poses.size(); ++i) {
    longest = std::max(longest, seconds_between(heard.poses[i - 1].utime, heard.poses[i].utime));
  }
  const double most = TrackOptions{}.pose_age;
  if (longest <= most) return;
  findings->push_back(
      tell(Verdict::kWarning,
           fmt::format("up to {:.3g} s from one on {} to the next, more than track.pose_age = {:g} "
                       "s",
                       longest, heard.channel, most),
           advise_rate(heard) + ", without breaks"));
}

/// Checks that there are at least as many poses as clouds.
void check_rate(const PoseArrivals& heard, Findings* findings) {
  if (heard.poses.size() < 2) {
    findings->push_back(tell(Verdict::kWarning,
                             fmt::format("only one on {} in {:.1f} s", heard.channel,
                                         seconds_between(heard.begin, heard.end)),
                             advise_rate(heard) + "; --seconds listens longer"));
    return;
  }
  // Rates that are counted in a short time differ a little even if they are equal, and that of two
  // clouds says little.
  constexpr double kAsFast = 0.9;
  constexpr std::size_t kFewest = 3;
  const double poses = rate_of(heard.poses), clouds = rate_of(heard.clouds);
  if (heard.clouds.size() < kFewest || poses >= kAsFast * clouds) return;
  findings->push_back(
      tell(Verdict::kWarning,
           fmt::format("{:.1f} Hz on {}, slower than the clouds' {:.1f} Hz: of the clouds between "
                       "two poses only the newest is handled",
                       poses, heard.channel, clouds),
           advise_rate(heard)));
}

void check_order(const PoseArrivals& heard, Findings* findings) {
  std::size_t older = 0;
  for (std::size_t i = 1; i < heard.poses.size(); ++i) {
    if (heard.poses[i].utime < heard.poses[i - 1].utime) ++older;
  }
  if (older == 0) return;
  findings->push_back(tell(Verdict::kWarning,
                           fmt::format("utime went backwards at {} of {} on {}", older,
                                       count_poses(heard.poses.size()), heard.channel),
                           "one sender a channel, which sends poses in the order of their times; "
                           "nothing if a log began anew"));
}

Finding describe_health(const PoseArrivals& heard, const std::vector<double>& waits) {
  std::string what = fmt::format("{} on {}", count_poses(heard.poses.size()), heard.channel);
  if (const double rate = rate_of(heard.poses); rate > 0.0)
    what += fmt::format(", {:.1f} Hz", rate);
  if (waits.empty()) {
    return tell(Verdict::kOk,
                what + "; no cloud came between them, so how long clouds wait is not known");
  }
  return tell(
      Verdict::kOk,
      fmt::format("{}; a cloud waits {:.0f} ms for the pose after it (half of them), {:.0f} "
                  "ms at the most",
                  what, kMsPerSecond * median_of(waits),
                  kMsPerSecond * *std::max_element(waits.begin(), waits.end())));
}

}  // namespace

Findings check_poses(const PoseArrivals& heard, const std::string& prefix) {
  Findings findings;
  if (heard.refused > 0) findings.push_back(describe_refusals(heard));
  if (heard.poses.empty()) {
    if (findings.empty()) findings.push_back(describe_absence(heard, prefix));
    return findings;
  }
  const bool stopped = have_stopped(heard);
  if (stopped) findings.push_back(describe_stop(heard));
  check_order(heard, &findings);
  constexpr double kMaxDifference = 1.0;
  const double difference = clock_difference(heard);
  if (std::abs(difference) > kMaxDifference) {
    // Times of another clock say nothing about the times between poses and clouds.
    findings.push_back(describe_clocks(heard, difference));
    return findings;
  }
  const std::vector<double> waits = waits_of(heard, stopped);
  check_waits(waits, &findings);
  check_gaps(heard, &findings);
  if (!stopped) check_rate(heard, &findings);
  if (findings.empty()) findings.push_back(describe_health(heard, waits));
  return findings;
}

}  // namespace quadrille::doctor
