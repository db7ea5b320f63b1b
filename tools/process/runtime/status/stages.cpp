#include "process/runtime/status/stages.hpp"

#include <algorithm>
#include <stdexcept>

namespace quadrille {

Stages::Stages(const std::vector<std::string>& names) {
  for (const std::string& name : names) stages_.emplace_back(name, bus::Durations());
}

void Stages::add(const std::string& name, double ms) {
  const auto stage = std::find_if(stages_.begin(), stages_.end(),
                                  [&](const auto& entry) { return entry.first == name; });
  if (stage == stages_.end()) throw std::out_of_range(name);
  stage->second.add(ms);
}

std::vector<stage_t> Stages::to_message() const {
  std::vector<stage_t> message;
  for (const auto& [name, durations] : stages_) {
    const bus::DurationSummary summary = durations.summary();
    message.emplace_back();
    stage_t& stage = message.back();
    stage.name = name;
    stage.count = durations.count();
    stage.total = durations.total();
    stage.p50 = summary.p50;
    stage.p90 = summary.p90;
    stage.p99 = summary.p99;
    stage.max = summary.max;
  }
  return message;
}

}  // namespace quadrille
