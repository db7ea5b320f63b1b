#include "quadrille/bus/rejection.hpp"

#include <numeric>

namespace quadrille::bus {

std::string_view to_string(RejectReason reason) {
  static constexpr std::array<std::string_view, kRejectReasonCount> kNames = {
      "too_large",  "unknown_type", "cut_short",   "bad_length", "trailing_bytes",
      "bad_layout", "bad_value",    "bad_channel", "internal"};
  return kNames.at(static_cast<std::size_t>(reason));
}

std::int64_t RejectCounts::total() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::int64_t{0});
}

}  // namespace quadrille::bus
