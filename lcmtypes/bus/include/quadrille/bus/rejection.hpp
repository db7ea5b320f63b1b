#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Why the bytes of a message were refused.
enum class RejectReason {
  kTooLarge,       ///< more bytes than the limit
  kUnknownType,    ///< no fingerprint that is understood here
  kCutShort,       ///< ends within a member
  kBadLength,      ///< a length that is negative, or more than the bytes that are left
  kTrailingBytes,  ///< bytes after the last member
  kBadLayout,      ///< records in which x, y, z cannot be found
  kBadValue,       ///< a value without meaning, such as an infinite coefficient
  kBadChannel,     ///< came on a channel too many, or on one with too long a name
  kInternal,       ///< valid perhaps, but not decoded: out of memory
};

inline constexpr int kRejectReasonCount = 9;

/// All the reasons, in their order.
constexpr std::array<RejectReason, kRejectReasonCount> all_reject_reasons() {
  std::array<RejectReason, kRejectReasonCount> reasons{};
  for (int i = 0; i < kRejectReasonCount; ++i) {
    reasons[static_cast<std::size_t>(i)] = static_cast<RejectReason>(i);
  }
  return reasons;
}

/// The name used in status messages, such as "cut_short".
QUADRILLE_EXPORT std::string_view to_string(RejectReason reason);

/// A refusal, with the member and the numbers it is about.
struct Rejection {
  RejectReason reason = RejectReason::kInternal;
  std::string detail;
};

/// What became of the bytes of one message.
template <class T>
using Decoded = std::variant<T, Rejection>;

/// Refusals counted by reason.
class RejectCounts {
 public:
  /// Counts one more refusal.
  void add(RejectReason reason) { ++counts_[static_cast<std::size_t>(reason)]; }
  /// Refusals for that reason so far.
  std::int64_t of(RejectReason reason) const { return counts_[static_cast<std::size_t>(reason)]; }
  /// Refusals so far.
  QUADRILLE_EXPORT std::int64_t total() const;

 private:
  std::array<std::int64_t, kRejectReasonCount> counts_{};
};

}  // namespace quadrille::bus
