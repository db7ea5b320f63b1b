#include "view/log/log_backend.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace quadrille::view {

LogBackend::LogBackend(LogFrames frames, std::vector<std::string> grippers, MakeScene make_scene,
                       const PackLimits& limits)
    : frames_(std::move(frames)),
      grippers_(std::move(grippers)),
      make_scene_(std::move(make_scene)),
      limits_(limits) {}

io::Json LogBackend::session() {
  io::Json policies = io::Json::array();
  for (const auto& [word, policy] : words_of(UnknownPolicy{})) policies.push_back(word);
  return {{"mode", "log"},
          {"name", frames_.path()},
          {"frames", frames_.utimes()},
          {"warning", frames_.defect().value_or("")},
          {"grippers", grippers_},
          {"policies", policies}};
}

Pack LogBackend::cached(const Key& key) {
  const std::lock_guard lock(cache_mutex_);
  const auto found = std::find_if(cache_.begin(), cache_.end(),
                                  [&](const auto& entry) { return entry.first == key; });
  if (found == cache_.end()) return nullptr;
  cache_.splice(cache_.begin(), cache_, found);
  return found->second;
}

void LogBackend::keep(const Key& key, const Pack& pack) {
  const std::lock_guard lock(cache_mutex_);
  cache_.emplace_front(key, pack);
  cached_bytes_ += pack->size();
  // The newest scene is always kept, however large it is.
  while (cached_bytes_ > kMaxCacheBytes && cache_.size() > 1) {
    cached_bytes_ -= cache_.back().second->size();
    cache_.pop_back();
  }
}

Pack LogBackend::frame(std::size_t number, const PlanChoice& choice) {
  if (number >= frames_.utimes().size()) return nullptr;
  const Key key(number, choice);
  if (const Pack pack = cached(key)) return pack;
  const std::lock_guard lock(work_mutex_);
  // Another request may have made the scene while this one was waiting.
  if (const Pack pack = cached(key)) return pack;
  auto frame = frames_.load(number);
  if (!frame) return nullptr;
  const auto pack = std::make_shared<const std::string>(
      pack_scene(make_scene_(std::move(*frame), choice), limits_));
  keep(key, pack);
  return pack;
}

}  // namespace quadrille::view
