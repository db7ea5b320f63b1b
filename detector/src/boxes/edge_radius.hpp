#pragma once

#include "boxes/box_draft.hpp"
#include "boxes/turning_edge.hpp"

namespace quadrille {

/// The radius of a box's edges, measured where two of its faces meet, and taken to be the same at
/// all edges [m]; 0 if they are sharp as far as noise lets one tell, or if no edge was seen.
///
/// A point at the depths a and b below two faces that meet at a right angle lies on a quarter of a
/// cylinder that touches both if (r − a)² + (r − b)² = r², so r = a + b + √(2ab). The median over
/// the points in the middle third of the quarter is taken.
double edge_radius(const BoxDraft& draft);

/// How far a box reaches beyond the end of one of its faces at an outline, behind which the edge
/// turns away from the sensor [m].
/// @param turning  what was seen of the edge there
/// @param radius   radius of the box's edges, see edge_radius() [m]
/// @param out_C    unit direction within the face's plane towards the edge
double reach_beyond(const Face& face, const TurningEdge& turning, double radius,
                    const Eigen::Vector3d& out_C, const DirectionIndex& sight);

}  // namespace quadrille
