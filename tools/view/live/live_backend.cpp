#include "view/live/live_backend.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace quadrille::view {
namespace {

/// Least time between scenes; the eye does not see more scenes per second, and the robot needs the
/// processor.
constexpr std::chrono::milliseconds kMinPeriod{50};
/// After each scene, the processor is left to others for this many times as long as the scene took.
constexpr int kRest = 4;

}  // namespace

LiveBackend::LiveBackend(const std::string& url, const LiveChannels& channels,
                         FindGripper find_gripper, bool allow_requests, const PackLimits& limits)
    : keeper_(channels),
      find_gripper_(std::move(find_gripper)),
      limits_(limits),
      allow_requests_(allow_requests),
      connection_(url),
      questions_(connection_, channels.requests) {
  subscribe();
  receiver_.emplace(connection_);
  maker_ = std::thread([this] { make_scenes(); });
}

LiveBackend::~LiveBackend() {
  stop_ = true;
  maker_.join();
}

void LiveBackend::subscribe() {
  LiveChannels::visit_inputs(keeper_.channels(), [this](const std::string& channel) {
    if (channel.empty()) return;
    connection_.subscribe(channel, [this](const std::string& name, std::span<const std::byte> b) {
      const bool is_answer = name == keeper_.channels().grasps && questions_.take(b);
      if (!is_answer) keeper_.take(name, b);
    });
  });
}

void LiveBackend::make_scenes() {
  while (!stop_) {
    if (!keeper_.wait(std::chrono::milliseconds(100))) continue;
    const auto start = std::chrono::steady_clock::now();
    const LiveChannels& channels = keeper_.channels();
    Pack pack = std::make_shared<const std::string>(
        pack_scene(live_scene(keeper_.latest(), find_gripper_, limits_, channels.cloud_in_world,
                              channels.unit),
                   limits_));
    {
      const std::lock_guard lock(mutex_);
      std::swap(newest_, pack);
      ++version_;
    }
    made_.notify_all();
    const auto made = std::chrono::steady_clock::now();
    std::this_thread::sleep_until(std::max(start + kMinPeriod, made + kRest * (made - start)));
  }
}

io::Json LiveBackend::session() {
  keeper_.watch();
  return {{"mode", "live"},
          {"name", connection_.url()},
          {"frames", io::Json::array()},
          {"requests", allow_requests_}};
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

std::int64_t LiveBackend::ask(const Question& question) {
  if (!allow_requests_) {
    throw NotAllowed("requests are off; start quadrille view with --allow-requests");
  }
  return questions_.ask(question);
}

io::Json LiveBackend::wait_answer(std::int64_t number, std::chrono::milliseconds timeout) {
  const Bytes bytes = questions_.wait(number, timeout);
  const auto scene = scene_of_answer(bytes, find_gripper_, limits_);
  return scene ? plan_json(*scene, limits_) : io::Json(nullptr);
}

}  // namespace quadrille::view
