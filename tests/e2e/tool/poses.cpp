// A camera that moves, with a ball that rides along before it, and whose poses come late or out of
// order: the ball's place in the fixed frame tells which pose each cloud was given.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <lcmtypes/bot_core/pose_t.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include "log/event_log.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "tool.hpp"

namespace quadrille::e2e {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::int64_t kStart = 1'000'000'000, kPosePeriod = 10'000, kCloudPeriod = 200'000;
constexpr std::int64_t kUsPerMs = 1000;
constexpr double kRadius = 0.15, kSpeed = 0.5;

/// The ball's centre in the camera's frame [m].
Eigen::Vector3d p_KB() { return {0.05, 0.02, 0.8}; }

/// The camera's place in the fixed frame: it looks along z and moves along x [m].
Eigen::Vector3d p_WK(std::int64_t utime) {
  return {kSpeed * 1e-6 * static_cast<double>(utime - kStart), 0.0, 0.0};
}

Bytes encode_pose(std::int64_t utime) {
  bot_core::pose_t pose{};
  pose.utime = utime;
  pose.pos[0] = p_WK(utime).x();
  pose.orientation[0] = 1.0;
  return bus::encode(pose);
}

/// The ball before a wall, in the camera's frame.
Bytes encode_cloud(std::int64_t utime) {
  constexpr int kWidth = 80, kHeight = 60;
  constexpr double kFocal = 80.0, kWall = 1.2;
  bus::CloudMessage message;
  message.utime = utime;
  PointCloud& cloud = message.cloud;
  cloud.frame = "eye";
  cloud.width = kWidth, cloud.height = kHeight, cloud.read = kWidth * kHeight;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray((u - 39.5) / kFocal, (v - 29.5) / kFocal, 1.0);
      const double b = ray.dot(p_KB()), a = ray.squaredNorm();
      const double root = b * b - a * (p_KB().squaredNorm() - kRadius * kRadius);
      cloud.points.push_back(
          ((root > 0.0 ? (b - std::sqrt(root)) / a : kWall) * ray).cast<float>());
    }
  }
  return bus::encode_cloud(message, bus::CloudFormat::kDrake);
}

struct Event {
  std::int64_t at = 0;
  std::string channel;
  Bytes bytes;
};

template <class Message>
Message decode(const Bytes& bytes) {
  Message message;
  if (message.decode(bytes.data(), 0, static_cast<int>(bytes.size())) < 0) {
    throw std::runtime_error("a message cannot be decoded");
  }
  return message;
}

/// True if the warnings of a message say that its cloud has no pose.
bool is_refused(const std::vector<std::string>& warnings) {
  return std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.starts_with("the camera's pose is not known: ");
  });
}

/// How many answers there are on a channel, and of how many clouds without a pose.
struct Answers {
  std::set<std::int64_t> placed, refused;
  /// Largest error of the ball's centre in the fixed frame, over all clouds [m].
  double error = 0.0;
};

void note_quadrics(const Bytes& bytes, Answers* answers) {
  const auto quadrics = std::get<bus::QuadricsMessage>(bus::decode_quadrics(bytes));
  if (is_refused(quadrics.warnings)) {
    answers->refused.insert(quadrics.utime);
    return;
  }
  answers->placed.insert(quadrics.utime);
  double nearest = INFINITY;
  for (const Detection& d : quadrics.detections) {
    if (d.type != QuadricType::kSphere) continue;
    const Eigen::Vector3d p_WB = p_WK(quadrics.utime) + p_KB();
    nearest = std::min(nearest, (d.X_CQ.translation() - p_WB).norm());
  }
  answers->error = std::max(answers->error, nearest);
}

void note_grasps(const Bytes& bytes, Answers* answers) {
  const auto grasps = decode<grasps_t>(bytes);
  (is_refused(grasps.warnings) ? answers->refused : answers->placed).insert(grasps.utime);
}

void expect(std::size_t got, std::size_t wanted, const std::string& what) {
  if (got == wanted) return;
  throw std::runtime_error(what + ": " + std::to_string(got) + " instead of " +
                           std::to_string(wanted));
}

/// The results of a log, in their order.
std::map<std::string, std::vector<Bytes>> read_results(const std::string& path) {
  std::map<std::string, std::vector<Bytes>> results;
  bus::LogReader log(path);
  while (const auto event = log.next()) {
    if (event->channel != "QUADRICS" && event->channel != "GRASPS") continue;
    results[event->channel].emplace_back(event->bytes.begin(), event->bytes.end());
  }
  return results;
}

}  // namespace

void make_pose_log(const std::string& path, const PoseTiming& timing) {
  std::vector<Event> events;
  const std::int64_t first = kStart - 50 * kPosePeriod,
                     last = kStart + timing.clouds * kCloudPeriod;
  std::mt19937 random(1);
  for (std::int64_t utime = first; utime <= last; utime += kPosePeriod) {
    // A pose out of order comes after the next one.
    const bool disordered = random() % 100 < static_cast<unsigned>(timing.percent_disordered);
    const std::int64_t at = utime + kUsPerMs * timing.poses_late_ms + (disordered ? 15000 : 0);
    events.push_back({at, "POSE", encode_pose(utime)});
  }
  for (int n = 0; n < timing.clouds; ++n) {
    // Between two poses, as of a camera that has a clock of its own.
    const std::int64_t utime = kStart + n * kCloudPeriod + 3700;
    events.push_back(
        {utime + kUsPerMs * timing.clouds_late_ms, "POINT_CLOUD", encode_cloud(utime)});
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.at < b.at; });
  bus::LogWriter log(path);
  for (const Event& event : events) log.write(event.at, event.channel, event.bytes);
  log.flush();
}

void check_poses(const std::string& path, const PosesExpected& expected) {
  Answers quadrics, grasps;
  auto results = read_results(path);
  for (const Bytes& bytes : results["QUADRICS"]) note_quadrics(bytes, &quadrics);
  for (const Bytes& bytes : results["GRASPS"]) note_grasps(bytes, &grasps);
  std::printf(
      "%s: %zu clouds placed, %zu refused, the ball at most %.3f mm off; %zu planned on, %zu not\n",
      path.c_str(), quadrics.placed.size(), quadrics.refused.size(), 1e3 * quadrics.error,
      grasps.placed.size(), grasps.refused.size());
  expect(quadrics.placed.size(), expected.placed, "clouds placed");
  expect(quadrics.refused.size(), expected.refused, "clouds refused");
  expect(grasps.placed.size(), expected.placed, "clouds planned on");
  expect(grasps.refused.size(), expected.refused, "clouds not planned on");
  if (!(quadrics.error < 1e-3)) throw std::runtime_error("a ball is more than 1 mm off");
}

void check_equal_results(const std::string& log, const std::string& other) {
  if (read_results(log) == read_results(other)) return;
  throw std::runtime_error(log + " and " + other + " hold other quadrics or grasps");
}

}  // namespace quadrille::e2e
