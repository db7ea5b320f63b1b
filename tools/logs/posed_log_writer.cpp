#include "logs/posed_log_writer.hpp"

#include <stdexcept>
#include <utility>

#include "link/connection.hpp"

namespace quadrille::logs {
namespace {

/// Time from one pose to the next, and from the first one to the first cloud [us].
constexpr std::int64_t kPeriod = 10'000, kAhead = 5'000;

CloudLogOptions with_poses(const CloudLogOptions& options) {
  options.check();
  if (options.rate > PosedLogWriter::kMaxRate) {
    throw std::invalid_argument("rate = " + std::to_string(options.rate) +
                                ": poses come at 100 Hz, so it may be at most 100");
  }
  return options;
}

}  // namespace

PosedLogWriter::PosedLogWriter(const std::string& path, const CloudLogOptions& options,
                               std::string pose_channel, PoseAt pose_at, const std::string& name)
    : options_(with_poses(options)),
      pose_channel_(std::move(pose_channel)),
      pose_at_(std::move(pose_at)),
      clouds_(path, options, name),
      utime_(options_.utime_of(1) - kAhead) {
  bus::check_channel(pose_channel_);
}

void PosedLogWriter::write(const PointCloud& cloud) {
  write_poses_until_next();
  clouds_.write(cloud);
}

void PosedLogWriter::write_before(const std::string& channel, std::span<const std::byte> bytes) {
  write_poses_until_next();
  clouds_.write(next_utime(), channel, bytes);
}

void PosedLogWriter::write_poses_until_next() {
  while (utime_ <= next_utime()) write_pose();
}

void PosedLogWriter::finish() {
  write_pose();
  clouds_.flush();
}

void PosedLogWriter::write_pose() {
  const double time = 1e-6 * static_cast<double>(utime_ - options_.utime_of(1));
  clouds_.write({utime_, pose_at_(time)}, pose_channel_);
  utime_ += kPeriod;
}

}  // namespace quadrille::logs
