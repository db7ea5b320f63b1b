#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "process/runtime/limited_log.hpp"
#include "quadrille/bus/rejection.hpp"
#include "run/rate_limiter.hpp"

namespace quadrille {

/// Counts the refused messages of a channel by reason, and logs them at a limited rate.
class Refusals {
 public:
  void add(const std::string& channel, const bus::Rejection& rejection);
  /// Returns a message that was decoded; adds it and returns nullopt if it was refused.
  template <class Message>
  std::optional<Message> accept(const std::string& channel, bus::Decoded<Message> decoded) {
    if (auto* message = std::get_if<Message>(&decoded)) return std::move(*message);
    add(channel, std::get<bus::Rejection>(decoded));
    return std::nullopt;
  }
  const bus::RejectCounts& counts() const { return counts_; }

 private:
  bus::RejectCounts counts_;
  LimitedLog log_;
};

/// Returns "none refused", or "3 refused (cut_short 1, bad_length 2)".
std::string describe(const bus::RejectCounts& counts);

}  // namespace quadrille
