#include "lab/trials/judged_trials.hpp"

#include <cstddef>
#include <optional>

#include "base/stage_clock.hpp"
#include "lab/trials/search_samples.hpp"
#include "surfaces/find_surfaces.hpp"

namespace quadrille::trials {
namespace {

std::vector<JudgedTrial> all_trials(const SearchSamples& samples, const DetectorOptions& options) {
  std::vector<JudgedTrial> trials;
  StageClock clock;
  find_surfaces(*samples.tree, samples.context, options, clock,
                [&](const Candidate& candidate, SearchLevel level, const Trial& trial) {
                  trials.push_back({candidate, level, trial, {}, std::nullopt});
                });
  return trials;
}

/// Judges all quadrics at once, because the frame's truth then has to be prepared only once.
void judge(const scoring::Frame& frame, std::vector<JudgedTrial>* trials) {
  std::vector<Quadric> quadrics;
  for (const JudgedTrial& t : *trials) {
    quadrics.push_back(t.candidate.Q);
    if (t.trial.surface) quadrics.push_back(t.trial.surface->Q);
  }
  const std::vector<scoring::Judgement> judgements = scoring::judge_each(frame, quadrics);
  std::size_t next = 0;
  for (JudgedTrial& t : *trials) {
    t.of_candidate = judgements[next++];
    if (t.trial.surface) t.of_surface = judgements[next++];
  }
}

}  // namespace

std::vector<JudgedTrial> judged_trials(const scoring::Frame& frame,
                                       const DetectorOptions& options) {
  const std::optional<SearchSamples> samples = search_samples(frame.cloud, options);
  if (!samples) return {};
  std::vector<JudgedTrial> trials = all_trials(*samples, options);
  judge(frame, &trials);
  return trials;
}

}  // namespace quadrille::trials
