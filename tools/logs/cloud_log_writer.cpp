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

CloudLogWriter::CloudLogWriter(const std::string& path, const CloudLogOptions& options,
                               const std::string& name)
    : options_(checked(options)), log_(path, name) {}

void CloudLogWriter::write(const PointCloud& cloud) {
  bus::CloudMessage message;
  message.utime = std::llround(static_cast<double>(clouds_ + 1) * 1e6 / options_.rate);
  message.seq = static_cast<std::int32_t>(clouds_);
  message.cloud = cloud;
  const auto encoded = bus::encode_cloud(message, options_.format);
  log_.write(message.utime, options_.channel, encoded);
  ++clouds_;
  bytes_ += static_cast<std::int64_t>(encoded.size());
}

}  // namespace quadrille::logs
