#pragma once

namespace quadrille {

/// The terms from which the score of a grasp is computed, each from 0 to 1. They are known before
/// the grasp is tried.
struct GraspTerms {
  /// Friction to spare: 1 − μ*/μ, less for pads that lie askew on a curved wall. Here μ* is that of
  /// a lean which is larger than the likeliest by one standard deviation.
  double friction = 0.0;
  /// Friction to spare divided by 0.3, at most 1: contacts are known to some degrees, which a small
  /// reserve does not cover; more than that makes no difference.
  double reserve = 0.0;
  /// Clearance divided by 10 mm, at most 1.
  double clearance = 0.0;
  /// Room between each pad and the target on the way in, divided by 5 mm, at most 1.
  double room = 0.0;
  /// 1 at the target's centre, 0 at its far end: a grasp near the centre leaves the target's weight
  /// a short lever.
  double central = 0.0;
  /// Share of the space that the fingers fill and pass through while they close that was seen;
  /// 1 if unknown space costs nothing (UnknownPolicy::kFree).
  double seen = 0.0;
  /// Score of the detection or box; 1 for a target without a shape.
  double confidence = 0.0;
  /// Distance from the sensor divided by 1.5 m, at most 1: the noise of depth cameras grows with
  /// it.
  double range = 0.0;
  /// 1 for a grasp across a wall at its rim.
  double rim = 0.0;
  /// 1 for a grasp that follows from a shape, 0 for one between the outermost points.
  double shape = 0.0;
  /// Share of the contacts at which no point at the pad's borders lies farther out than those
  /// within, and how far the points beside both contacts reach along the approach, divided by
  /// 20 mm. Both are 1 for a shape.
  double inner = 0.0, height = 0.0;
  /// Mean cosine between the pads' directions and the normals of the points next to them; share of
  /// the pads' area between which there are points; share of it at which these reach out nearly as
  /// far as the outermost one, at the pad where it is less. All are 1 for a shape, but the last is
  /// less where pads are to hold a wall across which it leans.
  double facing = 0.0, filled = 0.0, flat = 0.0;
  /// 1 for a shape whose width is known exactly, 0 where half of it is uncertain by 5 mm or more;
  /// 1 for a target without a shape.
  double sure = 0.0;

  /// Calls v(name, term) for each term.
  template <class Terms, class Visitor>
  static void visit(Terms& t, Visitor&& v) {
    v("friction", t.friction);
    v("reserve", t.reserve);
    v("clearance", t.clearance);
    v("room", t.room);
    v("central", t.central);
    v("seen", t.seen);
    v("confidence", t.confidence);
    v("range", t.range);
    v("rim", t.rim);
    v("shape", t.shape);
    v("inner", t.inner);
    v("height", t.height);
    v("facing", t.facing);
    v("filled", t.filled);
    v("flat", t.flat);
    v("sure", t.sure);
  }
};

}  // namespace quadrille
