#pragma once

#include "quadrille/grasping/grasp_query.hpp"
#include "targets/target.hpp"

namespace quadrille {

/// The id and the track under which a plan tells of a target.
struct TargetName {
  int id = 0, track = 0;
};

/// A robot takes a body as a whole, so a plan tells of all its parts under the id of the body. A
/// part that the query names by its own id or track is told of under these, unless the query names
/// the body's id too.
TargetName name_of(const Target& target, const GraspQuery& query);

}  // namespace quadrille
