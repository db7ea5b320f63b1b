#pragma once

#include <array>

#include "quadrille/detector/setting.hpp"

namespace quadrille::printed {

/// Ways to make surfaces of candidates.
enum class Surfaces {
  kInliers,   ///< clustered, and ranked by the number of samples on each, as the paper does
  kEvidence,  ///< clustered, and ranked by the evidence for each, which also refuses some
  kRefitted,  ///< the detector's way: refitted, weighed by their evidence, with claimed samples
};

constexpr auto words_of(Surfaces) {
  return std::to_array<Word<Surfaces>>({{"inliers", Surfaces::kInliers},
                                        {"evidence", Surfaces::kEvidence},
                                        {"refitted", Surfaces::kRefitted}});
}

/// Settings of the steps in which the paper's printed pipeline differs from the detector. The
/// defaults are the detector's way.
struct PrintedOptions {
  int pool = 0;
  int min_members = 1;
  double weight = 1.0;
  double lambda_scale = 1.0;
  int bins = 48;
  int levels = 3;
  Surfaces surfaces = Surfaces::kRefitted;

  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.pool, {"printed.pool", "", 0, 1e6,
               "Bases that are drawn all over a level and voted on by all of its samples. The "
               "hypotheses of all of them make one pool. 0: each neighbourhood gives the "
               "hypothesis that most of its own samples support, as in the detector."});
    v(o.min_members, {"printed.min_members", "", 1, 1e6,
                      "Hypotheses of a cluster at least, for a pool; fewer agree by chance."});
    v(o.weight, {"printed.weight", "", 1e-6, 1e6,
                 "w, the weight of a normal's rows beside a point's, for a pool."});
    v(o.lambda_scale, {"printed.lambda_scale", "", 1e-6, 1e6,
                       "λ₀, with which atan(λ / λ₀) is put into bins, for a pool."});
    v(o.bins, {"printed.bins", "", 4, 100000, "Bins of the votes for λ, for a pool."});
    v(o.levels, {"printed.levels", "", 1, 3,
                 "Levels of cells that are searched, from the finest on; the edges double from "
                 "one to the next."});
    v(o.surfaces, {"printed.surfaces", "How surfaces are made of candidates."});
  }

  /// @throws std::invalid_argument naming the field that is out of range
  void check() const { check_ranges(*this); }
};

}  // namespace quadrille::printed
