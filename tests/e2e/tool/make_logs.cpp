#include <cmath>
#include <lcmtypes/bot_core/pointcloud2_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <limits>

#include "logs/cloud_log_reader.hpp"
#include "logs/cloud_log_writer.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "tool.hpp"

namespace quadrille::e2e {
namespace {

using Bytes = std::vector<std::byte>;

/// A ball before a wall, as a depth camera of 80 x 60 pixels sees them; small enough to pass
/// through the receive buffer of a system as it is delivered.
PointCloud render_ball(double x) {
  constexpr int kWidth = 80, kHeight = 60;
  constexpr double kFocal = 80.0, kRadius = 0.15, kWall = 1.2;
  const Eigen::Vector3d center(x, 0.02, 0.8);
  PointCloud cloud;
  cloud.frame = "camera";
  cloud.width = kWidth;
  cloud.height = kHeight;
  cloud.read = kWidth * kHeight;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray((u - 39.5) / kFocal, (v - 29.5) / kFocal, 1.0);
      const double b = ray.dot(center), a = ray.squaredNorm();
      const double root = b * b - a * (center.squaredNorm() - kRadius * kRadius);
      const double depth = root > 0.0 ? (b - std::sqrt(root)) / a : kWall;
      cloud.points.push_back((depth * ray).cast<float>());
    }
  }
  return cloud;
}

Bytes encode_ball() {
  return bus::encode_cloud({5, 0, render_ball(0.0)}, bus::CloudFormat::kDrake);
}

Bytes encode_ball_with(void (*change)(drake::lcmt_point_cloud&)) {
  const Bytes bytes = encode_ball();
  drake::lcmt_point_cloud message;
  message.decode(bytes.data(), 0, static_cast<int>(bytes.size()));
  change(message);
  return bus::encode(message);
}

Bytes encode_quadrics_with(double first_coefficient) {
  Detection detection;
  detection.type = QuadricType::kSphere;
  Vector10d q = Vector10d::Zero();
  q[0] = first_coefficient;
  detection.Q_C = Quadric(q);
  detection.extent_Q = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()};
  DetectionResult result;
  result.detections = {detection};
  return bus::encode(bus::to_message(bus::CloudMessage{}, result));
}

Bytes cut(Bytes bytes, std::size_t size) {
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::vector<Garbage> make_garbage() {
  const std::string clouds = "POINT_CLOUD", quadrics = "QUADRICS";
  Bytes negative = encode_ball();
  // The length of the frame's name.
  for (std::size_t i = 16; i < 20; ++i) negative[i] = std::byte{0xff};
  Bytes long_data = encode_ball_with([](auto& m) { m.data.clear(), m.data_size = 0; });
  long_data[long_data.size() - 4] = std::byte{0x7f};
  return {
      {clouds, cut(encode_ball(), 11), "cut_short"},
      {clouds, Bytes(100, std::byte{0x55}), "unknown_type"},
      {clouds, cut(encode_ball(), 1000), "bad_length"},
      {clouds, negative, "bad_length"},
      {clouds, long_data, "bad_length"},
      {clouds, cut(encode_ball(), encode_ball().size() + 3), "trailing_bytes"},
      {clouds, encode_ball_with([](auto& m) { m.height = 1000000000, m.row_step = 1; }),
       "bad_layout"},
      {clouds, encode_ball_with([](auto& m) { m.fields[0].name.assign(1, 'u'); }), "bad_layout"},
      {clouds, encode_quadrics_with(1.0), "unknown_type"},
      {quadrics, encode_ball(), "unknown_type"},
      {quadrics, cut(encode_quadrics_with(1.0), 68), "bad_length"},
      {quadrics, encode_quadrics_with(std::numeric_limits<double>::quiet_NaN()), "bad_value"},
      {quadrics, encode_quadrics_with(7.0), "bad_value"},
  };
}

std::map<std::string, long> expected_rejections(const std::string& channel) {
  std::map<std::string, long> counts;
  for (const Garbage& garbage : make_garbage()) {
    if (garbage.channel == channel) ++counts[garbage.reason];
  }
  return counts;
}

void make_logs(const std::string& folder) {
  logs::CloudLogOptions options;
  options.rate = 2.0;
  logs::CloudLogWriter clouds(folder + "/clouds.lcm", options);
  for (int i = 0; i < kClouds; ++i) clouds.write(render_ball(-0.1 + 0.04 * i));
  clouds.flush();
  logs::CloudLogReader reader(folder + "/clouds.lcm");
  bus::LogWriter hostile(folder + "/hostile.lcm");
  bus::LogWriter numbered(folder + "/numbered.lcm");
  const std::vector<Garbage> garbage = make_garbage();
  std::size_t next = 0;
  while (const auto cloud = reader.next()) {
    const Bytes bytes = bus::encode_cloud(cloud->message, bus::CloudFormat::kPointCloud2);
    hostile.write(cloud->event_utime, cloud->channel, bytes);
    numbered.write(cloud->event_utime, cloud->channel, bytes);
    // Something that is no business of ours; it comes between a cloud and the next.
    hostile.write(cloud->event_utime + 10000, "POSE", Bytes(20));
    for (std::size_t i = 0; i < 3 && next < garbage.size(); ++i, ++next) {
      hostile.write(cloud->event_utime + 40000 * static_cast<std::int64_t>(i + 1),
                    garbage[next].channel, garbage[next].bytes);
    }
  }
  hostile.flush();
  numbered.flush();
}

}  // namespace quadrille::e2e
