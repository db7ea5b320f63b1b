#include "process/detector/untracked.hpp"

#include <fmt/format.h>

#include "process/runtime/limited_log.hpp"
#include "process/runtime/logging.hpp"

namespace quadrille {

void Untracked::add(const std::string& channel, std::int64_t cloud_utime, PoseLack lack,
                    const std::string& detail) {
  const char* what = searched_ ? "tracked" : "searched";
  ++counts_[static_cast<std::size_t>(lack)];
  const auto held_back = log_.admit();
  if (!held_back) return;
  log_warning(with_held_back(
      fmt::format("{}: cloud {} is not {}: {}", channel, cloud_utime, what, detail), *held_back));
}

std::vector<count_t> Untracked::to_message() const {
  constexpr std::array<const char*, 2> kNames = {"no_pose", "old_pose"};
  std::vector<count_t> message;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (counts_[i] == 0) continue;
    message.emplace_back();
    message.back().name = kNames[i];
    message.back().count = counts_[i];
  }
  return message;
}

}  // namespace quadrille
