#include "lab/bench/stages.hpp"

#include <algorithm>
#include <map>

#include "lab/scoring/score.hpp"
#include "lab/trials/judged_trials.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille::bench {
namespace {

using scoring::Judgement;
using scoring::Verdict;
using trials::JudgedTrial;

/// The furthest stage that each surface's trials reach, by the surface's id.
class Furthest {
 public:
  void add(const JudgedTrial& t) {
    // Beyond the stage of the fit, the better fit goes on, which may be another surface.
    note(t.of_candidate, std::min(t.trial.end, TrialEnd::kFit));
    if (t.of_surface) note(*t.of_surface, t.trial.end);
  }

  int count(TrialEnd end) const {
    return static_cast<int>(std::count_if(ends_.begin(), ends_.end(),
                                          [&](const auto& entry) { return entry.second == end; }));
  }
  int count() const { return static_cast<int>(ends_.size()); }

 private:
  void note(const Judgement& judgement, TrialEnd end) {
    if (judgement.verdict != Verdict::kRight) return;
    TrialEnd& furthest = ends_.emplace(judgement.surface, end).first->second;
    furthest = std::max(furthest, end);
  }

  std::map<int, TrialEnd> ends_;
};

bool is_wrong(const JudgedTrial& t) {
  return t.trial.end == TrialEnd::kAccepted && t.of_surface->verdict == Verdict::kWrong;
}

}  // namespace

StageCounts& StageCounts::operator+=(const StageCounts& other) {
  scenes += other.scenes, wanted += other.wanted;
  no_hypothesis += other.no_hypothesis, claimed += other.claimed;
  first_look += other.first_look, fit += other.fit;
  confidence += other.confidence, accepted += other.accepted;
  detected += other.detected, wrong += other.wrong;
  return *this;
}

StageCounts follow_stages(const scoring::Frame& frame, const DetectorOptions& options) {
  const scoring::FrameScore score =
      scoring::score(frame, scoring::findings_of(detect(frame.cloud, options)));
  StageCounts counts;
  counts.family = frame.family;
  counts.scenes = 1;
  counts.wanted = score.wanted;
  counts.detected = score.found;
  Furthest furthest;
  for (const JudgedTrial& t : trials::judged_trials(frame, options)) {
    furthest.add(t);
    counts.wrong += is_wrong(t);
  }
  counts.no_hypothesis = counts.wanted - furthest.count();
  counts.claimed = furthest.count(TrialEnd::kClaimed);
  counts.first_look = furthest.count(TrialEnd::kFirstLook);
  counts.fit = furthest.count(TrialEnd::kFit);
  counts.confidence = furthest.count(TrialEnd::kConfidence);
  counts.accepted = furthest.count(TrialEnd::kAccepted);
  return counts;
}

std::vector<StageCounts> count_stages(const FrameOptions& frames, const DetectorOptions& options) {
  std::map<int, StageCounts> families;
  for_each_frame(frames, [&](const scoring::Frame& frame, int family) {
    StageCounts& counts = families[family];
    counts.family = frame.family;
    counts += follow_stages(frame, options);
  });
  std::vector<StageCounts> list;
  for (const auto& [family, counts] : families) list.push_back(counts);
  return list;
}

}  // namespace quadrille::bench
