#pragma once

#include <cstdint>
#include <vector>

#include "quadrille/detector/export.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/setting.hpp"
#include "quadrille/detector/stage_options.hpp"

namespace quadrille {

/// Names of the types that a detector can find: all but the imaginary ones and coincident planes,
/// which are reported as a plane.
QUADRILLE_EXPORT std::vector<Word<QuadricType>> words_of(QuadricType);

/// All settings of the detector, stage by stage.
struct DetectorOptions {
  std::uint64_t seed = 1;
  int threads = 1;
  std::vector<QuadricType> only, report;

  SamplingOptions sampling;
  PlaneOptions planes;
  /// Decides whether a sample lies on a quadric, for search and aggregation.
  InlierTest inlier;
  SearchOptions search;
  AggregateOptions aggregate;
  ViewOptions views;

  /// Calls v(field, Setting) for each option of each stage, in the order of the configuration file.
  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.seed, {"seed", "Chooses the random stream."});
    v(o.threads, {"threads", "", 1, 256, "Threads to use; never changes the result."});
    v(o.only,
      {"only",
       "Find only these types; empty means all. If only spheres are sought, `quadrille detect` "
       "uses the defaults that `quadrille config --only sphere` prints: the paper's "
       "type-specific search. A plan needs all types, so then all are found, and only these "
       "are reported."});
    v(o.report, {"report",
                 "Report only these types; empty means all. The others are found too, and the "
                 "planner keeps clear of them, but they are not shown and not grasped."});
    SamplingOptions::visit(o.sampling, v);
    PlaneOptions::visit(o.planes, v);
    InlierTest::visit(o.inlier, v);
    SearchOptions::visit(o.search, v);
    AggregateOptions::visit(o.aggregate, v);
    ViewOptions::visit(o.views, v);
  }

  /// @throws std::invalid_argument naming the field that is out of range
  QUADRILLE_EXPORT void check() const;
};

/// Options with which spheres alone are found in less than half the time of the default (paper,
/// figure 2b): a hypothesis needs one point and no null space, and wide cells suffice. The other
/// families stay on offer, since they tell a sphere from a part of another surface.
QUADRILLE_EXPORT DetectorOptions sphere_preset();

}  // namespace quadrille
