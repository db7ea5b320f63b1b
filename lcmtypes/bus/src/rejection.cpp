#include "quadrille/bus/rejection.hpp"

#include <numeric>

namespace quadrille::bus {

std::string_view to_string(RejectReason reason) {
  switch (reason) {
    case RejectReason::kTooLarge:
      return "too_large";
    case RejectReason::kUnknownType:
      return "unknown_type";
    case RejectReason::kCutShort:
      return "cut_short";
    case RejectReason::kBadLength:
      return "bad_length";
    case RejectReason::kTrailingBytes:
      return "trailing_bytes";
    case RejectReason::kBadLayout:
      return "bad_layout";
    case RejectReason::kBadValue:
      return "bad_value";
    case RejectReason::kBadChannel:
      return "bad_channel";
    case RejectReason::kInternal:
      return "internal";
  }
  return "internal";
}

std::int64_t RejectCounts::total() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::int64_t{0});
}

}  // namespace quadrille::bus
