#include "io/cloud_file.hpp"
#include "lab/experiments/ball_sequence.hpp"
#include "lab/experiments/experiments.hpp"
#include "lab/experiments/sphere_errors.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille::experiments {

Report run_sequence(const Settings& settings) {
  const std::vector<BallSequence> sequences = read_sequences(real_scans());
  const std::size_t step = settings.quick ? 6 : 1;
  std::map<std::string, std::vector<SphereError>> groups;
  double before = 0.0;
  for (const BallSequence& sequence : sequences) {
    const std::vector<BallFrame>& frames = sequence.frames;
    const double share = 1.0 / static_cast<double>(sequences.size());
    for (std::size_t k = 0; k < frames.size(); k += step) {
      const DetectionResult result = detect(io::read_cloud(frames[k].file));
      groups[sequence.name].push_back(match(result, frames[k].ball));
      settings.progress(before + share * (k + 1.0) / static_cast<double>(frames.size()));
    }
    before += share;
  }
  return report_errors(groups);
}

}  // namespace quadrille::experiments
