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

#include "link/connection.hpp"
#include "process/runtime/limited_log.hpp"
#include "run/publish.hpp"

namespace quadrille {

/// A channel that a node listens to, and the option that names it.
struct InChannel {
  std::string option;
  /// Name of the channel, or a pattern of names as bus::ChannelPattern accepts it.
  std::string name;
  /// False if it is not a problem when nothing comes on the channel.
  bool expected = true;
};

/// A channel on which a node publishes, and the option that names it.
struct OutChannel {
  std::string option, name;
  /// True for several channels, whose names begin with this one and '_'.
  bool several = false;

  bool holds(const std::string& channel) const {
    return channel == name || (several && channel.starts_with(name + "_"));
  }
};

/// A piece of work that a message calls for.
struct Job {
  /// Utime of the cloud that the job is about [us].
  std::int64_t cloud_utime = 0;
  std::function<void()> run;
  /// Set for jobs that somebody waits for. No newer job replaces such a job, and if it cannot be
  /// done, this is called with the reason.
  std::function<void(const std::string& why)> refuse = {};
  /// Only newer jobs of the same kind replace this one. There are few kinds, such as channels.
  std::string kind = {};
};

/// State of a run that its node includes in the status.
struct RunState {
  /// Traffic received by the connection; empty in a replay.
  bus::Traffic traffic = {};
  /// Number of jobs dropped in favour of newer ones.
  std::int64_t superseded = 0;
  /// Warnings about the transport or the log.
  std::vector<std::string> warnings = {};
};

/// The work of a process, the same on the bus and in replay.
class Node {
 public:
  /// Time of a clock that never goes back: a steady clock on the bus, the log's event times in a
  /// replay.
  using Time = std::chrono::microseconds;

  Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  virtual ~Node() = default;

  virtual std::vector<InChannel> in_channels() const = 0;
  virtual std::vector<OutChannel> out_channels() const { return {}; }

  /// Receives a message. A message that is refused is counted and logged; one of another channel is
  /// ignored. For the receiving thread.
  /// @return the work that the message makes possible
  virtual std::optional<Job> receive(const std::string& channel,
                                     std::span<const std::byte> bytes) = 0;

  /// Returns the work that had to wait and is due now. For any thread, but not for two at once.
  virtual std::vector<Job> find_due_jobs(Time) { return {}; }

  /// Receives a message that comes at this time.
  /// @return the work to be done, in this order
  std::vector<Job> take(Time now, const std::string& channel, std::span<const std::byte> bytes);

  /// Returns a job to run while the node is idle, that is while no message waits. Only processes on
  /// the bus call it, from their working thread.
  virtual std::optional<Job> find_spare_job() { return std::nullopt; }

  /// Publishes the status. For a separate thread, also while a job is being done.
  /// @return the status in the text format that Prometheus reads
  virtual std::string publish_status(const RunState& run) = 0;

  /// Describes in one line what came in, went out and was refused so far.
  virtual std::string summary() const = 0;

  /// Returns oddities in the whole content of a log; empty if there are none.
  virtual std::vector<std::string> find_oddities() const { return {}; }

  /// Does a job; failures are counted and logged. For the working thread.
  void work(const Job& job);

  /// Tells the one who waits for a job that it is not done, and why; failures are logged.
  static void refuse(const Job& job, const std::string& why) noexcept;

  /// Number of jobs that failed.
  std::int64_t failed() const { return failed_; }

 private:
  std::atomic<std::int64_t> failed_{0};
  LimitedLog failure_log_;
};

/// Makes the node of a process, which publishes through the given function.
using NodeMaker = std::function<std::unique_ptr<Node>(bus::Publish publish)>;

}  // namespace quadrille
