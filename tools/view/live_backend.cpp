#include "view/live_backend.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace quadrille::view {
namespace {

/// Eyes do not see more than this many scenes a second, and the robot needs the processor.
constexpr std::chrono::milliseconds kMinPeriod{50};

/// Subscribes before the receiver starts.
bus::Connection& subscribed(bus::Connection& connection, MessageKeeper* keeper) {
  const LiveChannels& c = keeper->channels();
  for (const std::string& channel :
       {c.cloud, c.quadrics, c.boxes, c.grasps, c.occupancy, c.detector_status, c.planner_status}) {
    connection.subscribe(channel, [keeper](const std::string& name, std::span<const std::byte> b) {
      keeper->take(name, b);
    });
  }
  return connection;
}

}  // namespace

LiveBackend::LiveBackend(const std::string& url, const LiveChannels& channels,
                         FindGripper find_gripper, const PackLimits& limits)
    : keeper_(channels),
      find_gripper_(std::move(find_gripper)),
      limits_(limits),
      connection_(url),
      maker_([this] { make_scenes(); }),
      receiver_(subscribed(connection_, &keeper_)) {}

LiveBackend::~LiveBackend() {
  stop_ = true;
  maker_.join();
}

void LiveBackend::make_scenes() {
  while (!stop_) {
    if (!keeper_.wait(std::chrono::milliseconds(100))) continue;
    const auto start = std::chrono::steady_clock::now();
    Pack pack = std::make_shared<const std::string>(
        pack_scene(live_scene(keeper_.latest(), find_gripper_, limits_), limits_));
    {
      const std::lock_guard lock(mutex_);
      std::swap(newest_, pack);
      ++version_;
    }
    made_.notify_all();
    std::this_thread::sleep_until(start + kMinPeriod);
  }
}

io::Json LiveBackend::session() {
  keeper_.watch();
  return {{"mode", "live"}, {"name", connection_.url()}, {"frames", io::Json::array()}};
}

Pack LiveBackend::newest() {
  keeper_.watch();
  const std::lock_guard lock(mutex_);
  return newest_;
}

std::uint64_t LiveBackend::wait_newer(std::uint64_t version, std::chrono::milliseconds timeout) {
  keeper_.watch();
  std::unique_lock lock(mutex_);
  made_.wait_for(lock, timeout, [&] { return version_ != version; });
  return version_;
}

io::Json LiveBackend::status() { return live_status(keeper_.latest()); }

}  // namespace quadrille::view
