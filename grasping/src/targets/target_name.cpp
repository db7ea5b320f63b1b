#include "targets/target_name.hpp"

#include <algorithm>
#include <vector>

namespace quadrille {
namespace {

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

TargetName name_of(const Target& target, const GraspQuery& query) {
  const bool named = contains(query.ids, target.id) ||
                     (target.track != target.body_track && contains(query.tracks, target.track));
  // A query that names the body too asks for all of it.
  if (named && !contains(query.ids, target.body_id)) return {target.id, target.track};
  return {target.body_id, target.main_track};
}

}  // namespace quadrille
