#pragma once

#include <map>
#include <string>
#include <vector>

#include "lab/scoring/frame.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::scoring {

/// What a contender claims to have found.
struct Found {
  Quadric Q_C;
  double score = 0.0;
};

/// What the truth says of the findings in one frame.
struct FrameScore {
  /// Curved surfaces that had to be found, and of these the found ones.
  int wanted = 0, found = 0;
  /// Curved findings that are no such surface: doubles, fragments, fits to what is something else.
  int wrong = 0;
  /// Flat surfaces that had to be found, and of these the found ones; flat findings that are true
  /// and that are not.
  int planes_wanted = 0, planes_found = 0, planes_right = 0, planes_wrong = 0;
  /// For each found curved surface, the relative error of its width across the line of sight, as a
  /// gripper would close on it; infinite where the finding has none.
  std::vector<double> width_errors;
  /// How many of these are right within 10 %, or 4 mm.
  int widths_right = 0;

  FrameScore& operator+=(const FrameScore& other);

  /// Shares of the wanted surfaces that were found, of the curved findings that are right, and of
  /// the widths that are; then the same of planes. NaN where there is nothing to share.
  double recall() const;
  double precision() const;
  double right_width() const;
  double plane_recall() const;
  double plane_precision() const;
};

/// What quadrille claims.
std::vector<Found> findings_of(const DetectionResult& result);

/// Judges findings.
///
/// A finding is a surface if at least 60 % of the surface's points lie within max(2σ, min(2 % of
/// its size, 10 mm)) of it, by the first-order distance, with the true normal within 20° of its
/// gradient; and if of all points near the surface that do so at least 50 % are the surface's.
/// Findings and surfaces are paired one to one so that most surfaces are found. What finds a
/// surface that is hardly visible is neither right nor wrong. A finding whose gradient stays within
/// 12° of one direction over the points that support it is flat, and judged against the planes. The
/// 100 best are judged; all others are wrong.
/// @param only  count surfaces of this type alone, and let those of others pass; empty for all
FrameScore score(const Frame& frame, std::vector<Found> findings, const std::string& only = "");

/// What the truth says of one quadric, whatever else is found.
enum class Verdict {
  kRight,          ///< a surface that had to be found
  kHardlyVisible,  ///< a surface that need not be found
  kPlane,          ///< flat, and a plane of the scene
  kNoPlane,        ///< flat, and none of them
  kWrong,
};

/// A verdict, and the id of the surface that is meant; -1 if none is.
struct Judgement {
  Verdict verdict = Verdict::kWrong;
  int surface = -1;
};

/// Judges each quadric as if it were the only finding, by the rule of score().
std::vector<Judgement> judge_each(const Frame& frame, const std::vector<Quadric>& quadrics);

/// Pairs findings with the curved surfaces that had to be found, by the rule of score().
/// @return the index of the finding of each surface that was found, by the surface's id
std::map<int, int> pair_up(const Frame& frame, const std::vector<Found>& findings);

}  // namespace quadrille::scoring
