#include "quadrille/tracking.hpp"

namespace quadrille {

void Tracking::add_to(const InputCloud& input, const std::string& path, DetectionResult* result) {
  const bool logged = !input.channel.empty();
  if (!logged && !files_too_) return;
  // Files have no time; they get the one that `quadrille log` would give them.
  const std::int64_t utime = logged ? input.utime : 100000 * ++files_;
  auto [tracker, is_new] = trackers_.try_emplace({logged ? path : "", input.channel}, options_);
  tracker->second.update(utime, input.X_CK, result);
}

}  // namespace quadrille
