// Two views of a table with a can and a ball: as the clouds of one camera that was at both places,
// and as those of two cameras.
#include <cstdio>
#include <map>
#include <stdexcept>
#include <utility>

#include "log/event_log.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/pose_message.hpp"
#include "support/depth_camera.hpp"
#include "tool.hpp"

namespace quadrille::e2e {
namespace {

constexpr std::int64_t kFirst = 1'000'000, kSecond = 2'000'000;
// So many pixels make messages that a receive buffer of the stock size holds.
constexpr test::Camera kSmall{144, 108, 1.0 / 135.0, 0.0005};

Eigen::Vector3d eye_at(std::int64_t utime) {
  return utime == kFirst ? Eigen::Vector3d(-0.2, 0.5, 0.45) : Eigen::Vector3d(0.1, -0.55, 0.4);
}

/// Writes the view of one time on the channels of a camera.
void write_view(bus::LogWriter* log, std::int64_t utime, const std::string& clouds,
                const std::string& poses) {
  const Eigen::Isometry3d X_KW = test::world_seen_from(eye_at(utime));
  std::vector<test::Patch> patches = test::can(test::translation(0, 0, 0.05), 0.03, 0.1);
  patches.push_back(test::sphere(test::translation(0.15, 0.05, 0.03), 0.03));
  patches.push_back(test::rectangle(Eigen::Isometry3d::Identity(), 1.2, 1.0));
  for (test::Patch& patch : patches) patch.X_CB = X_KW * patch.X_CB;
  bus::CloudMessage message{utime, 0, test::render(patches, kSmall)};
  message.cloud.frame = "eye";
  log->write(utime, poses, bus::encode_pose({utime, X_KW.inverse()}));
  log->write(utime, clouds, bus::encode_cloud(message, bus::CloudFormat::kDrake));
}

/// The results of a log at the time of the second view, by channel.
std::map<std::string, std::vector<std::byte>> results_in(const std::string& path) {
  std::map<std::string, std::vector<std::byte>> results;
  bus::LogReader log(path);
  while (const auto event = log.next()) {
    const bool is_result = event->channel == "QUADRICS" || event->channel == "BOXES" ||
                           event->channel == "BODIES" || event->channel == "GRASPS";
    if (!is_result) continue;
    std::int64_t utime = 0;
    // The time stands behind the fingerprint.
    for (std::size_t i = 8; i < 16; ++i) {
      utime = utime << 8 | std::to_integer<std::int64_t>(event->bytes[i]);
    }
    if (utime == kSecond) results[event->channel].assign(event->bytes.begin(), event->bytes.end());
  }
  return results;
}

}  // namespace

void make_camera_logs(const std::string& folder) {
  bus::LogWriter one(folder + "/one.lcm"), side(folder + "/side.lcm"), front(folder + "/front.lcm");
  write_view(&one, kFirst, "POINT_CLOUD", "POSE");
  write_view(&one, kSecond, "POINT_CLOUD", "POSE");
  write_view(&side, kFirst, "SIDE", "SIDE_POSE");
  write_view(&front, kSecond, "POINT_CLOUD", "POSE");
  for (bus::LogWriter* log : {&one, &side, &front}) log->flush();
}

void check_cameras(const std::string& two, const std::string& one) {
  const auto of_two = results_in(two), of_one = results_in(one);
  if (of_one.size() != 4) throw std::runtime_error(one + " does not hold all results");
  for (const auto& [channel, bytes] : of_one) {
    const auto found = of_two.find(channel);
    std::printf("%s: %zu bytes\n", channel.c_str(), bytes.size());
    if (found == of_two.end()) throw std::runtime_error(two + " has no " + channel);
    if (found->second != bytes)
      throw std::runtime_error(channel + " differs from that of one camera");
  }
}

}  // namespace quadrille::e2e
