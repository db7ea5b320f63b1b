#include <algorithm>
#include <cstdio>
#include <lcmtypes/quadrille/collision_shapes_t.hpp>
#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <lcmtypes/quadrille/occupancy_t.hpp>
#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <lcmtypes/quadrille/quadrics_t.hpp>
#include <optional>
#include <stdexcept>

#include "log/event_log.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/tracker.hpp"
#include "tool.hpp"

namespace quadrille::e2e {
namespace {

using Bytes = std::vector<std::byte>;

void expect(bool true_condition, const std::string& what) {
  if (!true_condition) throw std::runtime_error(what);
}

void expect_equal(long got, long wanted, const std::string& what) {
  expect(got == wanted,
         what + ": " + std::to_string(got) + " instead of " + std::to_string(wanted));
}

/// Decodes what our own processes sent; nullopt for garbage of the test.
template <class Message>
std::optional<Message> decode(const Bytes& bytes) {
  Message message;
  const int size = static_cast<int>(bytes.size());
  // The generated decoder may throw on garbage, and misses trailing bytes.
  try {
    if (message.decode(bytes.data(), 0, size) == size) return message;
  } catch (const std::exception&) {
  }
  return std::nullopt;
}

/// The utime of a stamped message, which stands behind the fingerprint in all types.
std::int64_t utime_of(const Bytes& bytes) {
  std::int64_t utime = 0;
  for (std::size_t i = 8; i < 16; ++i) utime = utime << 8 | std::to_integer<std::int64_t>(bytes[i]);
  return utime;
}

bool is_garbage(const std::string& channel, const Bytes& bytes) {
  return channel == "QUADRICS" &&
         std::holds_alternative<bus::Rejection>(bus::decode_quadrics(bytes));
}

/// The messages of a channel by utime.
std::map<std::int64_t, Bytes> read_channel(const std::string& log, const std::string& channel) {
  std::map<std::int64_t, Bytes> messages;
  bus::LogReader reader(log);
  while (const auto event = reader.next()) {
    const Bytes bytes(event->bytes.begin(), event->bytes.end());
    if (event->channel != channel || is_garbage(channel, bytes)) continue;
    expect(messages.emplace(utime_of(bytes), bytes).second,
           log + ": two messages of one utime on " + channel);
  }
  return messages;
}

template <class Status>
Status read_last_status(const std::string& log, const std::string& channel) {
  const auto messages = read_channel(log, channel);
  expect(!messages.empty(), log + ": no status on " + channel);
  const auto status = decode<Status>(messages.rbegin()->second);
  expect(status.has_value(), log + ": the status on " + channel + " cannot be decoded");
  return *status;
}

void check_rejections(const std::vector<count_t>& got, const std::string& channel, bool hostile) {
  std::map<std::string, long> counts;
  for (const count_t& entry : got) counts[entry.name] = entry.count;
  const auto wanted = hostile ? expected_rejections(channel) : std::map<std::string, long>{};
  for (const auto& [reason, count] : wanted) {
    expect_equal(counts[reason], count, channel + ": refused as " + reason);
  }
  expect_equal(static_cast<long>(counts.size()), static_cast<long>(wanted.size()),
               channel + ": reasons");
}

long total(const std::map<std::string, long>& counts) {
  long sum = 0;
  for (const auto& [reason, count] : counts) sum += count;
  return sum;
}

const stage_t& find_stage(const std::vector<stage_t>& stages, const std::string& name) {
  const auto found = std::find_if(stages.begin(), stages.end(),
                                  [&](const stage_t& stage) { return stage.name == name; });
  expect(found != stages.end(), "no stage " + name);
  return *found;
}

/// Prints how long a stage took, and checks that it tells that.
void check_stage(const std::vector<stage_t>& stages, const std::string& name, long count) {
  const stage_t& stage = find_stage(stages, name);
  expect_equal(stage.count, count, "times of " + name);
  expect(stage.p50 > 0.0 && stage.p90 >= stage.p50 && stage.p99 >= stage.p90 &&
             stage.max >= stage.p99 && stage.total >= stage.max,
         "no times of " + name);
  std::printf("%s: %ld, p50 %.2f ms, max %.2f ms\n", name.c_str(), count, stage.p50, stage.max);
}

void check_process(const process_t& process) {
  expect(process.resident_bytes > 1000000 && process.peak_bytes >= process.resident_bytes,
         "no memory in the status");
  expect(process.uptime > 0.0 && process.cpu_time > 0.0, "no times in the status");
  expect(process.open_files > 3 && process.threads > 1, "no files or threads in the status");
  expect(process.settings.size() == 16 && !process.version.empty(), "no version in the status");
}

void check_detector(const std::string& log, bool hostile) {
  const auto status = read_last_status<detector_status_t>(log, "QUADRILLE_DETECTOR_STATUS");
  const long garbage = hostile ? total(expected_rejections("POINT_CLOUD")) : 0;
  expect_equal(status.received, kClouds + garbage, "clouds received");
  expect_equal(status.decoded, kClouds, "clouds decoded");
  expect_equal(status.failed, 0, "detections failed");
  expect_equal(status.published + status.superseded, kClouds, "clouds published or superseded");
  expect_equal(status.missing, 0, "clouds missing");
  for (const char* stage : {"wait", "detect", "quadrics"}) {
    check_stage(status.stages, stage, status.published);
  }
  check_stage(status.stages, "decode", kClouds);
  check_process(status.process);
  expect(status.transport.largest_message > 0 && status.transport.receive_buffer > 0,
         "nothing of the transport in the status");
  expect_equal(status.transport.dropped_datagrams, 0, "datagrams dropped");
  check_rejections(status.rejected, "POINT_CLOUD", hostile);
}

void check_planner(const std::string& log, bool hostile) {
  const auto detector = read_last_status<detector_status_t>(log, "QUADRILLE_DETECTOR_STATUS");
  const auto status = read_last_status<planner_status_t>(log, "QUADRILLE_PLANNER_STATUS");
  const long garbage = hostile ? total(expected_rejections("QUADRICS")) : 0;
  expect_equal(status.decoded_clouds, kClouds, "clouds decoded by the planner");
  expect_equal(status.received_quadrics, detector.published + garbage, "quadrics received");
  expect_equal(status.decoded_quadrics, detector.published, "quadrics decoded");
  expect_equal(status.paired, detector.published, "pairs");
  expect_equal(status.unpaired_quadrics, 0, "quadrics without their cloud");
  expect_equal(status.failed, 0, "plans failed");
  expect_equal(status.published + status.superseded, status.paired, "pairs published");
  check_rejections(status.rejected_clouds, "POINT_CLOUD", hostile);
  check_rejections(status.rejected_quadrics, "QUADRICS", hostile);
  for (const char* stage : {"wait", "plan", "grasps", "maps"}) {
    check_stage(status.stages, stage, status.published);
  }
  check_process(status.process);
}

}  // namespace

void check_quadrics(const std::string& log) {
  const auto clouds = read_channel(log, "POINT_CLOUD");
  const auto quadrics = read_channel(log, "QUADRICS");
  expect_equal(static_cast<long>(clouds.size()), kClouds, log + ": clouds");
  expect_equal(static_cast<long>(quadrics.size()), kClouds, log + ": quadrics");
  Tracker tracker;
  for (const auto& [utime, bytes] : clouds) {
    const auto cloud = std::get<bus::CloudMessage>(bus::decode_cloud(bytes));
    DetectionResult result = detect(cloud.cloud);
    tracker.update(utime, Eigen::Isometry3d::Identity(), &result.detections);
    for (const Detection& detection : result.detections) {
      expect(detection.track > 0 && detection.track <= 2, log + ": more tracks than surfaces");
    }
    const auto wanted = bus::encode(bus::to_message(cloud, result));
    expect(quadrics.at(utime) == wanted, log + ": other quadrics than detect() finds");
  }
}

void check_same(const std::string& live, const std::string& offline, const std::string& channel) {
  const auto got = read_channel(live, channel), wanted = read_channel(offline, channel);
  expect_equal(static_cast<long>(wanted.size()), kClouds, offline + ": messages on " + channel);
  for (const auto& [utime, bytes] : got) {
    const auto same = wanted.find(utime);
    expect(same != wanted.end() && same->second == bytes,
           channel + ": the message of utime " + std::to_string(utime) + " differs");
  }
  const auto detector = read_last_status<detector_status_t>(live, "QUADRILLE_DETECTOR_STATUS");
  const auto planner = read_last_status<planner_status_t>(live, "QUADRILLE_PLANNER_STATUS");
  const long published = channel == "QUADRICS" ? detector.published : planner.published;
  expect_equal(static_cast<long>(got.size()), published, live + ": messages on " + channel);
  expect(published > 0, live + ": nothing on " + channel);
}

void check_status(const std::string& log, bool hostile) {
  check_detector(log, hostile);
  check_planner(log, hostile);
}

}  // namespace quadrille::e2e
