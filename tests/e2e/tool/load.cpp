// Puts the processes under load as a driver would, over LCM alone: nothing here is of their code
// but the types of the messages.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <lcm/lcm-cpp.hpp>
#include <lcmtypes/bot_core/pointcloud2_t.hpp>
#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <lcmtypes/quadrille/quadrics_t.hpp>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "tool.hpp"

namespace quadrille::e2e {
namespace {

using Clock = std::chrono::steady_clock;
using Bytes = std::vector<std::uint8_t>;

/// The clouds of a log, whichever their type.
std::vector<Bytes> read_clouds(const std::string& path) {
  std::vector<Bytes> clouds;
  lcm::LogFile log(path, "r");
  if (!log.good()) throw std::runtime_error(path + ": cannot be read");
  while (const lcm::LogEvent* event = log.readNextEvent()) {
    if (event->channel != "POINT_CLOUD") continue;
    const auto* data = static_cast<const std::uint8_t*>(event->data);
    clouds.emplace_back(data, data + event->datalen);
  }
  if (clouds.empty()) throw std::runtime_error(path + ": no event on POINT_CLOUD");
  return clouds;
}

void write_number(std::int64_t number, int size, std::size_t at, Bytes* bytes) {
  for (int i = 0; i < size; ++i) {
    bytes->at(at + static_cast<std::size_t>(i)) =
        static_cast<std::uint8_t>(number >> (8 * (size - 1 - i)));
  }
}

/// Gives a cloud its number: as utime, and as seq where its type has one.
void stamp(std::int64_t number, Bytes* cloud) {
  write_number(number, 8, 8, cloud);
  Bytes fingerprint(8);
  write_number(bot_core::pointcloud2_t::getHash(), 8, 0, &fingerprint);
  if (std::equal(fingerprint.begin(), fingerprint.end(), cloud->begin())) {
    write_number(number, 4, 16, cloud);
  }
}

/// When clouds were sent and answered, and the detector's last status.
class Answers {
 public:
  explicit Answers(const std::string& url) : lcm_(url) {
    if (!lcm_.good()) throw std::runtime_error(url + ": no LCM");
    for (const char* channel : {"QUADRICS", "GRASPS", "QUADRILLE_DETECTOR_STATUS"}) {
      lcm_.subscribe(channel, &Answers::receive, this)->setQueueCapacity(0);
    }
    thread_ = std::thread([this] {
      while (!stop_) lcm_.handleTimeout(20);
    });
  }
  ~Answers() {
    stop_ = true;
    thread_.join();
  }

  void sent(std::int64_t utime) {
    const std::lock_guard lock(mutex_);
    sent_[utime] = Clock::now();
  }

  bool has(const std::string& channel, std::int64_t utime) const {
    const std::lock_guard lock(mutex_);
    const auto found = latencies_.find(channel);
    return found != latencies_.end() && found->second.count(utime) > 0;
  }

  bool detector_runs() const { return detector_runs_; }

  detector_status_t status() const {
    const std::lock_guard lock(mutex_);
    return status_;
  }

  void print(const std::string& channel) const {
    const std::lock_guard lock(mutex_);
    const auto found = latencies_.find(channel);
    if (found == latencies_.end()) return;
    std::vector<double> ms;
    for (const auto& [utime, latency] : found->second) ms.push_back(latency);
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double share) {
      return ms[std::min(ms.size() - 1, static_cast<std::size_t>(share * ms.size()))];
    };
    std::printf("%s: %zu of %zu clouds answered, ms p50 %.1f p90 %.1f p99 %.1f max %.1f\n",
                channel.c_str(), ms.size(), sent_.size(), at(0.5), at(0.9), at(0.99), ms.back());
  }

 private:
  void receive(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
    const std::lock_guard lock(mutex_);
    if (channel == "QUADRILLE_DETECTOR_STATUS") {
      detector_runs_ = true;
      detector_status_t status;
      if (status.decode(buffer->data, 0, static_cast<int>(buffer->data_size)) >= 0)
        status_ = status;
      return;
    }
    std::int64_t utime = 0;
    for (int i = 8; i < 16; ++i) {
      utime = utime << 8 | static_cast<const std::uint8_t*>(buffer->data)[i];
    }
    const auto found = sent_.find(utime);
    if (found == sent_.end()) return;
    latencies_[channel][utime] =
        std::chrono::duration<double, std::milli>(Clock::now() - found->second).count();
  }

  lcm::LCM lcm_;
  mutable std::mutex mutex_;
  std::map<std::int64_t, Clock::time_point> sent_;
  std::map<std::string, std::map<std::int64_t, double>> latencies_;
  detector_status_t status_{};
  std::atomic<bool> detector_runs_{false}, stop_{false};
  std::thread thread_;
};

/// Waits until something holds; false if it does not within a time that even a busy machine keeps.
template <class Condition>
bool wait_for(const Condition& condition) {
  for (int tries = 0; tries < 1500; ++tries) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

bool is_all_counted(const detector_status_t& status, const detector_status_t& before,
                    std::int64_t sent) {
  return status.received + status.missing == before.received + before.missing + sent &&
         status.published + status.superseded + status.failed == status.decoded;
}

void print_counts(const detector_status_t& status, std::int64_t sent) {
  std::printf("sent %ld: received %ld, missing %ld, superseded %ld, answered %ld\n",
              static_cast<long>(sent), static_cast<long>(status.received),
              static_cast<long>(status.missing), static_cast<long>(status.superseded),
              static_cast<long>(status.published));
}

}  // namespace

void put_under_load(const std::string& url, const std::string& log, const Load& load) {
  std::vector<Bytes> clouds = read_clouds(log);
  Answers answers(url);
  lcm::LCM sender(url);
  if (!wait_for([&] { return answers.detector_runs(); })) throw std::runtime_error("no detector");
  const detector_status_t before = answers.status();
  std::int64_t number = 0;
  const auto send = [&] {
    Bytes& cloud = clouds[static_cast<std::size_t>(number) % clouds.size()];
    stamp(++number, &cloud);
    answers.sent(number);
    sender.publish("POINT_CLOUD", cloud.data(), static_cast<unsigned>(cloud.size()));
  };
  const auto newest_is_answered = [&] { return answers.has("QUADRICS", number); };
  const auto period = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(1.0 / load.bursts_per_second));
  auto due = Clock::now();
  int unanswered = 0;
  for (int burst = 0; burst < load.bursts; ++burst, due += period) {
    std::this_thread::sleep_until(due);
    for (int i = 0; i < load.clouds_per_burst; ++i) send();
    if (load.clouds_per_burst == 1 || load.may_lose) continue;
    if (!wait_for(newest_is_answered)) ++unanswered;
    due = std::max(due, Clock::now());
  }
  if (load.may_lose) {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    send();
  }
  const bool counted = wait_for([&] { return is_all_counted(answers.status(), before, number); });
  print_counts(answers.status(), number);
  for (const char* channel : {"QUADRICS", "GRASPS"}) answers.print(channel);
  if (unanswered > 0 || !newest_is_answered()) {
    throw std::runtime_error(std::to_string(unanswered) + " bursts whose newest was not answered");
  }
  if (!counted) throw std::runtime_error("clouds are neither received nor counted as missing");
}

}  // namespace quadrille::e2e
