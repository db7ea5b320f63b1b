#pragma once

#include <map>
#include <string>
#include <vector>

#include "lab/scoring/found.hpp"
#include "lab/scoring/frame.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::scoring {

/// The result of comparing the findings in one frame with the truth.
struct FrameScore {
  /// Number of curved surfaces that had to be found, and of those that were.
  int wanted = 0, found = 0;
  /// Number of curved findings that are no such surface: duplicates, fragments, fits to something
  /// else.
  int wrong = 0;
  /// Number of flat surfaces that had to be found, and of those that were; number of right and of
  /// wrong flat findings.
  int planes_wanted = 0, planes_found = 0, planes_right = 0, planes_wrong = 0;
  /// Relative error of each found curved surface's width across the line of sight, as a gripper
  /// would close on it; infinite if the finding has no width there.
  std::vector<double> width_errors;
  /// Number of widths that are right within 10 %, or 4 mm.
  int widths_right = 0;
  /// For each curved surface that had to be found, found or not, the mean distance of its visible
  /// points, without their noise, from the finding to which it is least [m]. No distance is larger
  /// than the surface.
  std::vector<double> distances;

  FrameScore& operator+=(const FrameScore& other);

  /// Shares of the required surfaces that were found, of the curved findings that are right, and of
  /// the widths that are right; then recall and precision of planes. NaN if there is nothing to
  /// count.
  double recall() const;
  double precision() const;
  double right_width() const;
  double plane_recall() const;
  double plane_precision() const;
};

/// Converts the detections of quadrille to findings.
std::vector<Found> findings_of(const DetectionResult& result);

/// Judges findings.
///
/// A finding is a surface if at least 60 % of the surface's points lie within max(2σ, min(2 % of
/// its size, 10 mm)) of it, by the first-order distance, with the true normal within 20° of its
/// gradient, and if at least 50 % of all nearby points that do so belong to the surface. Findings
/// and surfaces are paired one to one so that most surfaces are found. A finding of a hardly
/// visible surface is neither right nor wrong. A finding whose gradient stays within 12° of one
/// direction over the points that support it is flat, and judged against the planes. Only the 100
/// best findings are judged; all others are wrong.
///
/// A superquadric is the surface of a whole body: the points of the body's other surfaces, such as
/// the lid of a cylinder, count as the surface's own.
/// @param only  counts surfaces of this type alone, and ignores those of others; empty for all
FrameScore score(const Frame& frame, std::vector<Found> findings, const std::string& only = "");

/// The judgement of one quadric, whatever else is found.
enum class Verdict {
  kRight,          ///< a surface that had to be found
  kHardlyVisible,  ///< a surface that need not be found
  kPlane,          ///< flat, and one of the scene's planes
  kNoPlane,        ///< flat, but none of the scene's planes
  kWrong,
};

/// A verdict, and the id of the surface that the quadric stands for; -1 if none.
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
