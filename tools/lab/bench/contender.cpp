#include "lab/bench/contender.hpp"

#include <filesystem>
#include <utility>

#include "lab/bench/peer_program.hpp"
#include "lab/bench/plain_ransac.hpp"
#include "lab/bench/stopwatch.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille::bench {
namespace {

Outcome run_quadrille(const Frame& frame, const DetectorOptions& options) {
  const Stopwatch stopwatch;
  const DetectionResult result = detect(frame.cloud, options);
  Outcome outcome{{}, stopwatch.wall_ms(), stopwatch.cpu_ms()};
  outcome.findings = scoring::findings_of(result);
  return outcome;
}

Contender variant(const std::string& name, const std::string& about, BasisKind basis) {
  DetectorOptions options;
  options.search.basis = basis;
  return {name, about, "", "", [options](const Frame& f) { return run_quadrille(f, options); }};
}

Contender sphere_variant() {
  DetectorOptions options;
  options.only = {QuadricType::kSphere};
  return {"quadrille-sphere", "quadrille --only sphere: bases of one point", "sphere", "",
          [options](const Frame& f) { return run_quadrille(f, options); }};
}

Contender plain(const std::string& name, const std::string& about, const PlainOptions& options) {
  return {name, about, "", "", [options](const Frame& frame) {
            const Stopwatch stopwatch;
            Outcome outcome;
            outcome.findings = plain_ransac(frame.cloud.points, options);
            outcome.wall_ms = stopwatch.wall_ms();
            outcome.cpu_ms = stopwatch.cpu_ms();
            return outcome;
          }};
}

Contender plain_nine() { return plain("plain-nine", "plain RANSAC, nine points a basis", {}); }

Contender plain_four() {
  PlainOptions options;
  options.basis = PlainBasis::kFourOrientedPoints;
  options.min_cosine = 0.85;
  options.trials = 1500;
  return plain("plain-four", "plain RANSAC, four oriented points a basis", options);
}

Contender peer(const std::string& name, const std::string& about, const std::string& package,
               const std::string& programs) {
  const std::string program = programs + "/quadrille-peer-" + name;
  std::string absent;
  if (!std::filesystem::exists(program)) {
    absent = "not built for lack of " + package + "; tools/setup --bench, then configure and build";
  }
  return {name, about, "", absent,
          [program](const Frame& frame) { return run_program_on(program, frame); }};
}

}  // namespace

std::vector<Contender> all_contenders(const std::string& programs) {
  return {
      variant("quadrille", "quadrille as it comes: three points a basis, and a vote",
              BasisKind::kThreePoints),
      variant("quadrille-four", "search.basis = four_points", BasisKind::kFourPoints),
      variant("quadrille-nine", "search.basis = nine_points", BasisKind::kNinePoints),
      sphere_variant(),
      plain_nine(),
      plain_four(),
      peer("cgal", "CGAL Efficient RANSAC, tuned per family", "libcgal-dev", programs),
      peer("pcl", "PCL SACSegmentationFromNormals in clusters, tuned per family", "libpcl-dev",
           programs),
  };
}

}  // namespace quadrille::bench
