#include "lab/bench/contender.hpp"

#include <filesystem>
#include <utility>

#include "lab/bench/ems.hpp"
#include "lab/bench/given_objects.hpp"
#include "lab/bench/peer_program.hpp"
#include "lab/bench/plain_ransac.hpp"
#include "lab/bench/stopwatch.hpp"
#include "variants/measured_quantisation.hpp"
#include "variants/variant.hpp"

namespace quadrille::bench {
namespace {

Contender own(const std::string& name, const std::string& about, const std::string& only,
              const std::function<DetectionResult(const CloudView&)>& detect) {
  return {name, about, only, "", [detect](const Frame& frame) {
            const Stopwatch stopwatch;
            const DetectionResult result = detect(frame.cloud);
            Outcome outcome{{}, stopwatch.wall_ms(), stopwatch.cpu_ms()};
            outcome.findings = scoring::findings_of(result);
            return outcome;
          }};
}

/// The search for spheres alone, with the settings of a file over its preset.
DetectorOptions sphere_options(io::DetectorConfig config) {
  config.detector.only = {QuadricType::kSphere};
  return io::search_options(config);
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

/// A contender that gets the points of each object. The time is that of all objects together.
Contender on_objects(const std::string& name, const std::string& about,
                     const std::function<std::vector<Found>(const PointCloud&)>& find) {
  const auto run = [find](const Frame& frame) {
    const std::vector<PointCloud> objects = given_objects(frame);
    const Stopwatch stopwatch;
    Outcome outcome;
    for (const PointCloud& object : objects) {
      for (const Found& found : find(object)) outcome.findings.push_back(found);
    }
    outcome.wall_ms = stopwatch.wall_ms();
    outcome.cpu_ms = stopwatch.cpu_ms();
    return outcome;
  };
  return {name, about, "", "", run, true};
}

Contender quadrille_objects(const DetectorOptions& options) {
  return on_objects("quadrille-objects",
                    "quadrille on the points of each object, given their segmentation",
                    [options](const PointCloud& object) {
                      return scoring::findings_of(detect(object, options));
                    });
}

Contender ems() {
  return on_objects("ems", "superquadrics by EMS (CVPR 2022), one for each object, given the same",
                    [](const PointCloud& object) -> std::vector<Found> {
                      const auto fit = fit_superquadric(object.points);
                      if (!fit) return {};
                      return {{Quadric(), fit->inliers, fit->superquadric}};
                    });
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

std::vector<Contender> all_contenders(const std::string& programs,
                                      const io::DetectorConfig& config) {
  const DetectorOptions& options = config.detector;
  const auto variant = [&](const std::string& name, const std::string& about, const Variant& way) {
    return own(name, about, "", [options, way](const CloudView& cloud) {
      return detect_variant(cloud, options, way);
    });
  };
  return {
      own("quadrille", "quadrille as it comes: three points a basis, and a vote", "",
          [options](const CloudView& cloud) { return detect(cloud, options); }),
      variant("quadrille-two", "bases of two points, and a vote in three dimensions",
              {.basis = VariantBasis::kTwoPoints}),
      variant("quadrille-four", "bases of four points", {.basis = VariantBasis::kFourPoints}),
      variant("quadrille-nine", "bases of nine points", {.basis = VariantBasis::kNinePoints}),
      variant("quadrille-solved", "gradient lengths that three points solve for",
              {.lengths = GradientLengths::kSolved}),
      variant("quadrille-measured", "votes in bins of equal mass", {.quantisation = kMeasured}),
      variant("quadrille-hashed", "no basis is voted on twice", {.hash_triplets = true}),
      variant("quadrille-confident", "no more bases than the best surface so far takes",
              {.confidence = 0.95}),
      variant("quadrille-clusters", "raw hypotheses are agglomerated",
              {.clusters = ClusterOptions()}),
      variant("quadrille-agglomerate", "candidates are clustered by d_close and d_far",
              {.agglomerate = AgglomerateOptions()}),
      own("quadrille-sphere", "quadrille --only sphere: bases of one point", "sphere",
          [spheres = sphere_options(config)](const CloudView& cloud) {
            return detect(cloud, spheres);
          }),
      plain_nine(),
      plain_four(),
      quadrille_objects(options),
      ems(),
      peer("cgal", "CGAL Efficient RANSAC, tuned per family", "libcgal-dev", programs),
      peer("pcl", "PCL SACSegmentationFromNormals in clusters, tuned per family", "libpcl-dev",
           programs),
  };
}

}  // namespace quadrille::bench
