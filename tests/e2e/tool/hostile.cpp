// Sends what a broken or hostile sender might, between clouds that have to be answered.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <lcm/lcm-cpp.hpp>
#include <lcmtypes/bot_core/pose_t.hpp>
#include <lcmtypes/quadrille/grasp_request_t.hpp>
#include <limits>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>

#include "tool.hpp"

namespace quadrille::e2e {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Sample {
  std::string channel;
  Bytes bytes;
};

template <class Message>
Bytes encode(const Message& message) {
  Bytes bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

/// The messages of a log, with a request and a pose, which no log of the processes' output has.
std::vector<Sample> read_samples(const std::string& path) {
  std::vector<Sample> samples;
  lcm::LogFile log(path, "r");
  if (!log.good()) throw std::runtime_error(path + ": cannot be read");
  while (const lcm::LogEvent* event = log.readNextEvent()) {
    const auto* data = static_cast<const std::uint8_t*>(event->data);
    // One that has nothing behind its fingerprint cannot be changed.
    if (event->datalen > 16) samples.push_back({event->channel, {data, data + event->datalen}});
  }
  grasp_request_t request{};
  request.request_id = 1;
  request.targets = {1, 2};
  request.num_targets = 2;
  request.types = {"sphere"};
  request.num_types = 1;
  samples.push_back({"GRASP_REQUEST", encode(request)});
  bot_core::pose_t pose{};
  pose.orientation[0] = 1.0;
  samples.push_back({"POSE", encode(pose)});
  return samples;
}

template <class Number>
Number pick(const std::vector<Number>& numbers, std::mt19937& random) {
  return numbers[random() % numbers.size()];
}

/// Writes the bytes of a number, the highest first as LCM has them, or last as clouds' points do.
template <class Number>
void put(Number number, bool big_endian, std::size_t at, Bytes& bytes) {
  auto raw = std::bit_cast<std::array<std::uint8_t, sizeof(Number)>>(number);
  if (big_endian) std::reverse(raw.begin(), raw.end());
  for (std::size_t i = 0; i < raw.size() && at + i < bytes.size(); ++i) bytes[at + i] = raw[i];
}

/// Writes a number as often as that, the lowest bytes first.
void put_run(float number, std::size_t count, std::size_t at, Bytes& bytes) {
  for (std::size_t i = 0; i < count; ++i) put(number, false, at + 4 * i, bytes);
}

/// Changes, cuts or lengthens a message at random places, mostly by numbers that make trouble.
Bytes mutate(Bytes bytes, std::mt19937& random) {
  using Float = std::numeric_limits<float>;
  using Double = std::numeric_limits<double>;
  static const std::vector<std::int32_t> integers = {-1,      0,          1,       2,        4096,
                                                     1 << 20, 0x40000001, INT_MAX, INT32_MIN};
  static const std::vector<float> floats = {1e30f,
                                            -1e30f,
                                            1e22f,
                                            1e23f,
                                            Float::max(),
                                            Float::infinity(),
                                            Float::quiet_NaN(),
                                            Float::denorm_min(),
                                            0.0f,
                                            -0.0f,
                                            65.535f,
                                            1e4f,
                                            1e-20f};
  static const std::vector<double> doubles = {
      1e300, -1e300, 1e30, Double::infinity(), Double::quiet_NaN(), Double::denorm_min(), 0.0, 1e9};
  // The fingerprint stays, or nothing is read on.
  const std::size_t first = 8, places = bytes.size() - first;
  const int changes = 1 << random() % 7;
  for (int i = 0; i < changes; ++i) {
    const std::size_t at = first + random() % places;
    switch (random() % 8) {
      case 0:
        bytes[at] = static_cast<std::uint8_t>(random());
        break;
      case 1:
        put(pick(integers, random), true, at, bytes);
        break;
      case 2:
        put(pick(doubles, random), true, at, bytes);
        break;
      case 3:
        // A patch of pixels that a driver marks as missing.
        put_run(pick(floats, random), 1 + random() % 300, at, bytes);
        break;
      default:
        put(pick(floats, random), false, at, bytes);
    }
  }
  if (random() % 16 == 0) bytes.resize(8 + random() % bytes.size());
  return bytes;
}

void write_utime(std::int64_t utime, Bytes& cloud) { put(utime, true, 8, cloud); }

/// The utimes of the clouds that were answered.
class AnsweredUtimes {
 public:
  explicit AnsweredUtimes(const std::string& url) : lcm_(url) {
    if (!lcm_.good()) throw std::runtime_error(url + ": no LCM");
    for (const char* channel : {"QUADRICS", "GRASPS"}) {
      lcm_.subscribe(channel, &AnsweredUtimes::receive, this)->setQueueCapacity(0);
    }
    thread_ = std::thread([this] {
      while (!stop_) lcm_.handleTimeout(20);
    });
  }
  ~AnsweredUtimes() {
    stop_ = true;
    thread_.join();
  }

  bool have(std::int64_t utime) {
    const std::lock_guard lock(mutex_);
    return utimes_["QUADRICS"].contains(utime) && utimes_["GRASPS"].contains(utime);
  }

 private:
  void receive(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
    if (buffer->data_size < 16) return;
    const auto* data = static_cast<const std::uint8_t*>(buffer->data);
    std::int64_t utime = 0;
    for (int i = 8; i < 16; ++i) utime = utime << 8 | data[i];
    const std::lock_guard lock(mutex_);
    utimes_[channel].insert(utime);
  }

  lcm::LCM lcm_;
  std::mutex mutex_;
  std::map<std::string, std::set<std::int64_t>> utimes_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// Sends a good cloud until it is answered: what is sent before it may still fill the processes'
/// hands. False if that takes longer than a busy machine with sanitizers may need.
bool is_answered(Sample cloud, std::int64_t utime, lcm::LCM& sender, AnsweredUtimes& answered) {
  write_utime(utime, cloud.bytes);
  for (int tries = 0; tries < 30; ++tries) {
    sender.publish(cloud.channel, cloud.bytes.data(), static_cast<unsigned>(cloud.bytes.size()));
    for (int waits = 0; waits < 50; ++waits) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      if (answered.have(utime)) return true;
    }
  }
  return false;
}

}  // namespace

void send_hostile(const std::string& url, const std::string& log, const Hostile& asked) {
  const std::vector<Sample> samples = read_samples(log);
  const Sample* good = nullptr;
  for (const Sample& sample : samples) {
    if (sample.channel == "POINT_CLOUD") good = &sample;
  }
  if (good == nullptr) throw std::runtime_error(log + ": no event on POINT_CLOUD");
  const std::vector<std::string> channels = {"POINT_CLOUD", "QUADRICS", "GRASP_REQUEST", "POSE",
                                             "QUADRILLE_DETECTOR_STATUS"};
  AnsweredUtimes answered(url);
  lcm::LCM sender(url);
  std::mt19937 random(static_cast<unsigned>(asked.seed));
  // Far from the utimes of the log.
  std::int64_t good_utime = std::int64_t{1} << 40;
  constexpr int kBetween = 500;
  int clouds = 0;
  for (long sent = 0; sent < asked.messages; ++sent) {
    if (sent % kBetween == 0) {
      if (!is_answered(*good, ++good_utime, sender, answered)) {
        throw std::runtime_error("after " + std::to_string(sent) +
                                 " hostile messages a good cloud is not answered");
      }
      ++clouds;
    }
    const Sample& sample = samples[random() % samples.size()];
    const Bytes bytes = mutate(sample.bytes, random);
    // One in ten comes where another type is expected.
    const std::string& channel = random() % 10 == 0 ? pick(channels, random) : sample.channel;
    sender.publish(channel, bytes.data(), static_cast<unsigned>(bytes.size()));
    if (sent % asked.at_once == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (!is_answered(*good, ++good_utime, sender, answered)) {
    throw std::runtime_error("the last good cloud is not answered");
  }
  std::printf("%ld hostile messages; %d good clouds, each answered\n", asked.messages, clouds + 1);
}

}  // namespace quadrille::e2e
