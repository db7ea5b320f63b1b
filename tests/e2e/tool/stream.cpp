// A stream of clouds that may tell no time, and what comes back of it: each cloud is known by the
// number of its points alone.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <lcm/lcm-cpp.hpp>
#include <lcmtypes/quadrille/quadrics_t.hpp>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "quadrille/bus/cloud_message.hpp"
#include "tool.hpp"

namespace quadrille::e2e {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kFewestPoints = 3000;

/// A ball before a wall, in rays on a spiral.
std::vector<std::byte> make_cloud(int number, bool tells_time) {
  const double radius = 0.15, wall = 1.2;
  const Eigen::Vector3d center(0.0, 0.0, 0.8);
  bus::CloudMessage message;
  message.utime = tells_time ? 1'000'000 + number : 0;
  PointCloud& cloud = message.cloud;
  cloud.frame = "camera";
  cloud.width = kFewestPoints + number;
  cloud.height = 1;
  cloud.read = static_cast<std::size_t>(cloud.width);
  for (int i = 0; i < cloud.width; ++i) {
    const double r = 0.5 * std::sqrt(static_cast<double>(i) / cloud.width), angle = 2.399963 * i;
    const Eigen::Vector3d ray(r * std::cos(angle), r * std::sin(angle), 1.0);
    const double b = ray.dot(center), a = ray.squaredNorm();
    const double root = b * b - a * (center.squaredNorm() - radius * radius);
    cloud.points.push_back(((root > 0.0 ? (b - std::sqrt(root)) / a : wall) * ray).cast<float>());
  }
  return bus::encode_cloud(message, bus::CloudFormat::kDrake);
}

/// What comes on one channel of quadrics.
class Listener {
 public:
  Listener(const std::string& url, const std::string& channel) : lcm_(url) {
    if (!lcm_.good()) throw std::runtime_error(url + ": no LCM");
    lcm_.subscribe(channel, &Listener::receive, this)->setQueueCapacity(0);
    thread_ = std::thread([this] {
      while (!stop_) lcm_.handleTimeout(20);
    });
  }
  ~Listener() {
    stop_ = true;
    thread_.join();
  }

  /// The numbers of the clouds that were answered, as they came, and when.
  std::vector<std::pair<int, Clock::time_point>> answers() const {
    const std::lock_guard lock(mutex_);
    return answers_;
  }

 private:
  void receive(const lcm::ReceiveBuffer*, const std::string&, const quadrics_t* quadrics) {
    const std::lock_guard lock(mutex_);
    answers_.emplace_back(static_cast<int>(quadrics->points_read) - kFewestPoints, Clock::now());
  }

  lcm::LCM lcm_;
  mutable std::mutex mutex_;
  std::vector<std::pair<int, Clock::time_point>> answers_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

double percentile(const std::vector<double>& sorted, double share) {
  const auto at = static_cast<std::size_t>(share * static_cast<double>(sorted.size()));
  return sorted.empty() ? 0.0 : sorted[std::min(sorted.size() - 1, at)];
}

}  // namespace

void stream(const std::string& url, const Stream& asked) {
  std::vector<std::vector<std::byte>> clouds;
  for (int i = 0; i < asked.clouds; ++i) clouds.push_back(make_cloud(i, asked.tells_time));
  const Listener merged(url, "QUADRICS");
  lcm::LCM sender(url);
  std::vector<Clock::time_point> sent;
  const auto period = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(1.0 / asked.clouds_per_second));
  const auto start = Clock::now();
  for (const auto& cloud : clouds) {
    std::this_thread::sleep_until(start + static_cast<int>(sent.size()) * period);
    sent.push_back(Clock::now());
    sender.publish("POINT_CLOUD", cloud.data(), static_cast<unsigned>(cloud.size()));
  }
  std::this_thread::sleep_for(std::chrono::seconds(2));
  std::vector<double> ms;
  int disordered = 0, last = -1;
  for (const auto& [number, when] : merged.answers()) {
    if (number <= last) ++disordered;
    last = std::max(last, number);
    ms.push_back(std::chrono::duration<double, std::milli>(when - sent.at(number)).count());
  }
  std::sort(ms.begin(), ms.end());
  std::printf(
      "%zu of %d answered, %d twice or out of order; ms p50 %.1f p90 %.1f p99 %.1f max %.1f\n",
      ms.size(), asked.clouds, disordered, percentile(ms, 0.5), percentile(ms, 0.9),
      percentile(ms, 0.99), percentile(ms, 1.0));
  if (disordered > 0) throw std::runtime_error("results are not in the order of the clouds");
  if (static_cast<int>(ms.size()) < asked.least_answered) throw std::runtime_error("too few");
}

}  // namespace quadrille::e2e
