#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Reasons why the bytes of a message were refused.
enum class RejectReason {
  kTooLarge,       ///< more bytes than the limit
  kUnknownType,    ///< a fingerprint that is not understood here
  kCutShort,       ///< the message ends within a member
  kBadLength,      ///< a length that is negative or exceeds the remaining bytes
  kTrailingBytes,  ///< bytes after the last member
  kBadLayout,      ///< records in which x, y, z cannot be found
  kBadValue,       ///< a value without meaning, such as an infinite coefficient
  kBadChannel,     ///< it came on one channel too many, or on one with too long a name
  kInternal,       ///< possibly valid, but not decoded: out of memory
};

inline constexpr int kRejectReasonCount = 9;

/// All reasons in their order.
constexpr std::array<RejectReason, kRejectReasonCount> all_reject_reasons() {
  std::array<RejectReason, kRejectReasonCount> reasons{};
  for (int i = 0; i < kRejectReasonCount; ++i) {
    reasons[static_cast<std::size_t>(i)] = static_cast<RejectReason>(i);
  }
  return reasons;
}

/// The name used in status messages, such as "cut_short".
QUADRILLE_EXPORT std::string_view to_string(RejectReason reason);

/// A refusal, with a description of the member and the numbers concerned.
struct Rejection {
  RejectReason reason = RejectReason::kInternal;
  std::string detail;
};

/// The decoded message, or the reason why it was refused.
template <class T>
using Decoded = std::variant<T, Rejection>;

/// Refusals counted by reason.
class RejectCounts {
 public:
  /// Counts one more refusal.
  void add(RejectReason reason) { ++counts_[static_cast<std::size_t>(reason)]; }
  /// Number of refusals for that reason so far.
  std::int64_t of(RejectReason reason) const { return counts_[static_cast<std::size_t>(reason)]; }
  /// Number of all refusals so far.
  QUADRILLE_EXPORT std::int64_t total() const;

 private:
  std::array<std::int64_t, kRejectReasonCount> counts_{};
};

}  // namespace quadrille::bus
