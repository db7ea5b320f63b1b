#pragma once

#include <cstdint>
#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pairing.hpp"
#include "quadrille/bus/durations.hpp"
#include "quadrille/bus/publish.hpp"
#include "quadrille/bus/rate_limiter.hpp"
#include "quadrille/bus/rejection.hpp"
#include "settings.hpp"

namespace quadrille {

/// The work of the process, the same on the bus and in replay.
class PlannerNode {
 public:
  PlannerNode(const PlannerSettings& settings, bus::Publish publish);

  /// Takes a message of the clouds' or the quadrics' channel; one that is refused is counted and
  /// logged, one of another channel ignored. For the receiving thread.
  /// @return the pair that the message completes
  std::optional<CloudAndQuadrics> receive(const std::string& channel,
                                          std::span<const std::byte> bytes);

  /// Plans and publishes; what fails is counted and logged. For the working thread.
  void handle(const CloudAndQuadrics& pair);

  /// Publishes the status.
  /// @param superseded  pairs dropped for a newer one
  /// @param warnings    what is wrong with the transport
  void publish_status(std::int64_t superseded, const std::vector<std::string>& warnings);

  /// Pairs on which the planning failed.
  std::int64_t failed() const;
  /// Pairs so far.
  std::int64_t paired() const;

  /// The utime of the last message that passed all checks [us].
  std::int64_t last_utime() const;

 private:
  template <class Message>
  std::optional<CloudAndQuadrics> accept(bus::Decoded<Message> decoded, const std::string& channel,
                                         std::int64_t* accepted, bus::RejectCounts* rejected);
  void log_rejection(const std::string& channel, const bus::Rejection& rejection);
  void plan_and_publish(const CloudAndQuadrics& pair);
  template <class Message>
  std::int64_t publish(const std::string& channel, const Message& message);
  planner_status_t make_status() const;

  const PlannerSettings settings_;
  const bus::Publish publish_;
  const std::int64_t dropped_before_;
  bus::RateLimiter rejection_log_{std::chrono::seconds(1)};

  mutable std::mutex mutex_;
  Pairing pairing_;
  std::int64_t last_utime_ = 0;
  planner_status_t counts_{};
  bus::RejectCounts rejected_clouds_, rejected_quadrics_;
  bus::Durations latencies_, plans_;
};

}  // namespace quadrille
