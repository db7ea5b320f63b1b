#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "process/runtime/limited_log.hpp"
#include "quadrille/bus/connection.hpp"
#include "quadrille/bus/publish.hpp"

namespace quadrille {

/// A channel that a node listens to, and the option that names it.
struct InChannel {
  std::string option;
  /// Or a pattern of names, as bus::ChannelPattern takes it.
  std::string name;
  /// False if it is no fault when nothing comes on it.
  bool expected = true;
};

/// A channel on which a node publishes, and the option that names it.
struct OutChannel {
  std::string option, name;
  /// True if it stands for several, whose names begin with this one and '_'.
  bool several = false;

  bool holds(const std::string& channel) const {
    return channel == name || (several && channel.starts_with(name + "_"));
  }
};

/// What a message asks for.
struct Job {
  /// The utime of the cloud that it is about [us].
  std::int64_t cloud_utime = 0;
  std::function<void()> run;
  /// Set for what somebody waits for: no newer job replaces it, and if it cannot be done this is
  /// told why.
  std::function<void(const std::string& why)> refuse = {};
  /// Only newer jobs of the same kind replace this one. There are few kinds, such as channels.
  std::string kind = {};
};

/// What a run tells its node, for the status.
struct RunState {
  /// What the connection has received; nothing in a replay.
  bus::Traffic traffic = {};
  /// Jobs dropped for a newer one.
  std::int64_t superseded = 0;
  /// What is wrong with the transport, or odd about the log.
  std::vector<std::string> warnings = {};
};

/// The work of a process, the same on the bus and in replay.
class Node {
 public:
  /// Of a clock that never goes back: on the bus a steady one, in a replay that of the log's
  /// events.
  using Time = std::chrono::microseconds;

  Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  virtual ~Node() = default;

  virtual std::vector<InChannel> in_channels() const = 0;
  virtual std::vector<OutChannel> out_channels() const { return {}; }

  /// Takes a message; one that is refused is counted and logged, one of another channel ignored.
  /// For the receiving thread.
  /// @return what is to be done now that it is there
  virtual std::optional<Job> receive(const std::string& channel,
                                     std::span<const std::byte> bytes) = 0;

  /// What is to be done of that which had to wait, now that it is so late. For any thread, but not
  /// for two at once.
  virtual std::vector<Job> find_due_jobs(Time) { return {}; }

  /// Takes a message that comes at that time.
  /// @return what is to be done, in this order
  std::vector<Job> take(Time now, const std::string& channel, std::span<const std::byte> bytes);

  /// What is to be done while no message asks for anything. For the working thread, on the bus.
  virtual std::optional<Job> find_spare_job() { return std::nullopt; }

  /// Publishes the status. For a thread of its own, also while a job is done.
  /// @return the same in the text format that Prometheus reads
  virtual std::string publish_status(const RunState& run) = 0;

  /// What went in, came out and was refused so far, in one line.
  virtual std::string summary() const = 0;

  /// What is odd about all that a log held; empty if nothing is.
  virtual std::vector<std::string> find_oddities() const { return {}; }

  /// Does a job; what fails is counted and logged. For the working thread.
  void work(const Job& job);

  /// Tells whoever waits for a job that it is not done, and why; what fails is logged.
  static void refuse(const Job& job, const std::string& why) noexcept;

  /// Jobs that failed.
  std::int64_t failed() const { return failed_; }

 private:
  std::atomic<std::int64_t> failed_{0};
  LimitedLog failure_log_;
};

/// Makes the node of a process, which publishes through what it is given.
using NodeMaker = std::function<std::unique_ptr<Node>(bus::Publish publish)>;

}  // namespace quadrille
