#include "process/runtime/refusals.hpp"

#include <fmt/format.h>

#include "process/runtime/limited_log.hpp"
#include "process/runtime/logging.hpp"

namespace quadrille {

void Refusals::add(const std::string& channel, const bus::Rejection& rejection) {
  counts_.add(rejection.reason);
  const auto held_back = log_.admit();
  if (!held_back) return;
  log_warning(with_held_back(fmt::format("{}: refused a message: {} ({})", channel,
                                         to_string(rejection.reason), rejection.detail),
                             *held_back));
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
