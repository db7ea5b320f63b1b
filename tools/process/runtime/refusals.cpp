#include "process/runtime/refusals.hpp"

#include <fmt/format.h>

namespace quadrille {

void Refusals::add(const std::string& channel, const bus::Rejection& rejection) {
  counts_.add(rejection.reason);
  log_.warning(fmt::format("{}: refused a message: {} ({})", channel, to_string(rejection.reason),
                           rejection.detail));
}

std::string describe(const bus::RejectCounts& counts) {
  if (counts.total() == 0) return "none refused";
  std::string reasons;
  for (const bus::RejectReason reason : bus::all_reject_reasons()) {
    if (counts.of(reason) == 0) continue;
    reasons +=
        fmt::format("{}{} {}", reasons.empty() ? "" : ", ", to_string(reason), counts.of(reason));
  }
  return fmt::format("{} refused ({})", counts.total(), reasons);
}

}  // namespace quadrille
