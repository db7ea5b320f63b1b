#include "doctor/examine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <optional>
#include <stdexcept>

#include "doctor/check_network.hpp"
#include "doctor/check_poses.hpp"
#include "doctor/check_traffic.hpp"
#include "doctor/listen.hpp"
#include "doctor/round_trip.hpp"
#include "link/network.hpp"
#include "run/clock.hpp"

namespace quadrille::doctor {
namespace {

constexpr std::size_t kUsualBytes = bus::kUsualCloudBytes;

/// Runs a check; an exception becomes a failure of that check.
Finding attempt(const std::string& check, const std::function<Finding()>& examine,
                const std::string& remedy = "see above") {
  try {
    return examine();
  } catch (const std::exception& error) {
    return {Verdict::kFailed, check, error.what(), remedy};
  }
}

int port_of(const bus::Url& url) { return ntohs(bus::multicast_group(url).sin_port); }

void append(const Findings& more, Findings* findings) {
  findings->insert(findings->end(), more.begin(), more.end());
}

void examine_trips(const bus::Url& url, std::size_t cloud_bytes, const std::string& buffers,
                   Findings* findings) {
  using std::chrono::milliseconds;
  const Trip small{100, 200, milliseconds(5)};
  const Trip large{10, cloud_bytes, milliseconds(100)};
  findings->push_back(attempt("small messages", [&] {
    return check_trip("small messages", small, make_trip(url, small), "");
  }));
  if (findings->back().verdict == Verdict::kFailed) return;
  findings->push_back(attempt("large messages", [&] {
    return check_trip("large messages", large, make_trip(url, large), buffers);
  }));
}

/// Listens to the bus; if that fails, adds a finding.
std::optional<Traffic> try_to_listen(const bus::Url& url, double seconds, PoseRecorder* poses,
                                     Findings* findings) {
  std::optional<Traffic> heard;
  const Finding failure = attempt(
      "listening",
      [&] {
        heard = listen(url, std::chrono::milliseconds(static_cast<int>(1000.0 * seconds)), poses);
        return Finding{};
      },
      fmt::format("see who holds the port: ss -lunp sport = :{}; and net.ipv4.igmp_max_memberships",
                  port_of(url)));
  if (!heard) findings->push_back(failure);
  return heard;
}

void examine_traffic(const Traffic& traffic, const bus::Url& url, const Questions& questions,
                     Findings* findings) {
  findings->push_back(
      check_clouds(traffic, questions.cloud_channel, questions.seconds, questions.channel_prefix));
  findings->push_back(check_losses(traffic, port_of(url)));
  append(check_others(traffic, questions.cloud_channel), findings);
  append(check_clocks(traffic, bus::wall_clock_utime()), findings);
}

void examine_udpm(const bus::Url& url, const Questions& questions, Findings* findings) {
  findings->push_back(attempt("route", [&] { return check_route(url); }));
  if (has_failure(*findings)) return;
  findings->push_back(check_interface(url));
  findings->push_back(check_ttl(url));
  PoseRecorder recorder(questions.pose_channel, questions.cloud_channel, bus::wall_clock_utime());
  const std::optional<Traffic> traffic = try_to_listen(url, questions.seconds, &recorder, findings);
  const PoseArrivals poses = recorder.heard(bus::wall_clock_utime());
  const std::size_t seen = traffic ? traffic->largest_cloud() : 0;
  const bool is_told = questions.cloud_bytes > 0;
  const std::size_t bytes = is_told ? questions.cloud_bytes : (seen > 0 ? seen : kUsualBytes);
  const Finding buffers =
      check_buffers(buffers_of(url), static_cast<std::int64_t>(bytes),
                    is_told ? "--cloud-bytes" : (seen > 0 ? "seen on the bus" : "640x480 points"));
  findings->push_back(buffers);
  examine_trips(url, bytes, buffers.remedy, findings);
  if (!traffic) return;
  examine_traffic(*traffic, url, questions, findings);
  if (!questions.pose_channel.empty()) {
    append(check_poses(poses, questions.channel_prefix), findings);
  }
}

/// Over a server the doctor cannot listen without taking part.
void examine_server(const bus::Url& url, const Questions& questions, Findings* findings) {
  examine_trips(url, questions.cloud_bytes > 0 ? questions.cloud_bytes : kUsualBytes,
                findings->front().remedy, findings);
  if (questions.pose_channel.empty()) return;
  findings->push_back(
      {Verdict::kWarning, kPoseCheck,
       fmt::format("not looked at: the doctor listens to udpm only, not to {}", url.provider),
       "--lcm-url udpm://..., or see pose_age and untracked in the detector's "
       "status"});
}

}  // namespace

Findings examine(const Questions& questions) {
  bus::Url url;
  Findings findings;
  findings.push_back(attempt(
      "address",
      [&] {
        url = bus::parse_url(questions.url);
        return check_address(url);
      },
      kMendAddress));
  if (has_failure(findings)) return findings;
  if (url.provider == "udpm") {
    examine_udpm(url, questions, &findings);
  } else {
    examine_server(url, questions, &findings);
  }
  return findings;
}

}  // namespace quadrille::doctor
