#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/experiments/ball_scene.hpp"
#include "lab/experiments/experiments.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/experiments/sphere_errors.hpp"
#include "lab/experiments/true_sphere.hpp"
#include "lab/scoring/frame.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille::experiments {
namespace {

/// Allowed error as a share of the diameter, as printed for the rugby ball.
constexpr double kAllowed = 0.05;

/// The results over one sequence.
struct BallOutcome {
  const GeneratedSequence* sequence;
  int frames = 0, found = 0;
  /// Frames in which least squares on the ball's own pixels finds it, and those of them in which
  /// the detector finds it, too.
  int fitted = 0, found_of_fitted = 0;
  /// False spheres among the ball and the clutter.
  int wrong = 0;
  std::vector<double> seen, times;
};

/// True if least squares on the ball's true pixels gives the ball; only for spheres.
bool is_fitted(const BallFrameScene& frame, const scoring::Frame& made, double radius) {
  const int ball = made.surfaces.back().id;
  std::vector<Eigen::Vector3d> points;
  for (std::size_t k = 0; k < made.cloud.points.size(); ++k) {
    if (made.labels[k] == ball) points.push_back(made.cloud.points[k].cast<double>());
  }
  if (points.size() < 4) return false;
  const FittedSphere sphere = fit_sphere(points);
  const double most = kAllowed * 2.0 * radius;
  return (sphere.centre - frame.centre_C).norm() <= most &&
         std::abs(sphere.radius - radius) <= most;
}

void run_frame(double time, std::uint64_t seed, BallOutcome* outcome, Table* data) {
  const GeneratedSequence& sequence = *outcome->sequence;
  const BallFrameScene frame = ball_scene(sequence, time, seed);
  const DetectorOptions options = sequence.sphere_alone ? sphere_preset() : DetectorOptions();
  const scoring::Frame made = scoring::frame_of(frame.made);
  DetectionResult result;
  const double us = microseconds([&] { result = detect(made.cloud, options); });
  const bool found = std::any_of(
      result.detections.begin(), result.detections.end(), [&](const Detection& detection) {
        return is_ball(detection, frame.centre_C, sequence.axes, kAllowed);
      });
  const bool round = sequence.axes.minCoeff() == sequence.axes.maxCoeff();
  const bool fitted = round && is_fitted(frame, made, sequence.axes.x());
  ++outcome->frames;
  outcome->found += found;
  outcome->fitted += fitted;
  outcome->found_of_fitted += fitted && found;
  outcome->wrong += false_spheres(made, result);
  outcome->seen.push_back(frame.seen);
  outcome->times.push_back(1e-3 * us);
  data->row(sequence.name, time, frame.seen, found ? "1" : "0", fitted ? "1" : "0");
}

std::string row_of(const BallOutcome& o, Table* table) {
  const GeneratedSequence& s = *o.sequence;
  const std::string rate = fmt::format("{:.1f} %", 100.0 * o.found / o.frames);
  table->row(
      s.name,
      fmt::format("{:g} x {:g} x {:g}", 2e2 * s.axes.x(), 2e2 * s.axes.y(), 2e2 * s.axes.z()),
      s.sphere_alone ? "sphere" : "generic", o.frames,
      fmt::format("{:.0f} %", 100.0 * quantile(o.seen, 0.5)), fmt::format("{:.1f} %", s.printed),
      rate, o.fitted == 0 ? "-" : fmt::format("{} of {}", o.found_of_fitted, o.fitted),
      fmt::format("{}", o.wrong), quantile(o.times, 0.5));
  return fmt::format("{} {}", s.name, rate);
}

}  // namespace

Report run_balls(const Settings& settings) {
  const int frames = settings.quick ? 3 : 60;
  Report report;
  report.data.columns = {"sequence", "time", "seen", "found", "fitted"};
  Table table{"Table 1 with generated sequences",
              {"sequence", "diameters [cm]", "search", "frames", "seen, median", "printed", "found",
               "of those that least squares finds", "false spheres", "detection [ms]"},
              {}};
  std::string rates;
  double done = 0.0;
  for (const GeneratedSequence& sequence : ball_sequences()) {
    BallOutcome outcome{&sequence, 0, 0, 0, 0, 0, {}, {}};
    const std::uint64_t seed = settings.seed * 1000 + static_cast<std::uint64_t>(done);
    for (int k = 0; k < frames; ++k) {
      run_frame(k / (frames - 1.0), seed, &outcome, &report.data);
      settings.progress((done + (k + 1.0) / frames) / static_cast<double>(ball_sequences().size()));
    }
    ++done;
    rates += (rates.empty() ? "" : ", ") + row_of(outcome, &table);
  }
  report.findings = {
      fmt::format("Found is a ball whose centre and semi-axes are right to {:.0f} % of its "
                  "diameter, frame by frame, without tracks: {}.",
                  100.0 * kAllowed, rates)};
  report.tables = {table};
  return report;
}

}  // namespace quadrille::experiments
