#include "process/runtime/watch/sequence_gaps.hpp"

namespace quadrille {

void SequenceGaps::add(const std::string& frame, std::int32_t seq) {
  const auto source = last_.find(frame);
  if (source == last_.end()) {
    if (last_.size() < kMaxSources) last_.emplace(frame, seq);
    return;
  }
  const std::int64_t step = std::int64_t{seq} - source->second;
  if (step > 1 && step <= kMaxStep) missing_ += step - 1;
  source->second = seq;
}

}  // namespace quadrille
