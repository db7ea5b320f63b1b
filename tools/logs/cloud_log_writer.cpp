#include "logs/cloud_log_writer.hpp"

#include <cmath>
#include <stdexcept>

#include "link/connection.hpp"

namespace quadrille::logs {
namespace {

CloudLogOptions checked(const CloudLogOptions& options) {
  options.check();
  return options;
}

}  // namespace

void CloudLogOptions::check() const {
  if (!(rate >= kMinRate && rate <= kMaxRate)) {
    throw std::invalid_argument("rate = " + std::to_string(rate) +
                                ": must lie between 0.001 and 10000");
  }
  bus::check_channel(channel);
}

std::int64_t CloudLogOptions::utime_of(std::int64_t n) const {
  return std::llround(static_cast<double>(n) * 1e6 / rate);
}

CloudLogWriter::CloudLogWriter(const std::string& path, const CloudLogOptions& options,
                               const std::string& name)
    : options_(checked(options)), log_(path, name) {}

void CloudLogWriter::write(const PointCloud& cloud) {
  bus::CloudMessage message;
  message.utime = options_.utime_of(clouds_ + 1);
  message.seq = static_cast<std::int32_t>(clouds_);
  message.cloud = cloud;
  const auto encoded = bus::encode_cloud(message, options_.format);
  log_.write(message.utime, options_.channel, encoded);
  ++clouds_;
  bytes_ += static_cast<std::int64_t>(encoded.size());
}

void CloudLogWriter::write(const bus::PoseMessage& pose, const std::string& channel) {
  write(pose.utime, channel, bus::encode_pose(pose));
}

void CloudLogWriter::write(std::int64_t utime, const std::string& channel,
                           std::span<const std::byte> bytes) {
  log_.write(utime, channel, bytes);
  bytes_ += static_cast<std::int64_t>(bytes.size());
}

}  // namespace quadrille::logs
