#include "targets/asked_for.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "targets/target_name.hpp"

namespace quadrille {
namespace {

template <class Value>
bool allows(const std::vector<Value>& values, const Value& value) {
  return values.empty() || std::find(values.begin(), values.end(), value) != values.end();
}

bool lies_in(const Region& region, const Eigen::Vector3d& p_C) {
  return region.box_R.contains(region.X_CR.inverse() * p_C);
}

/// Returns the longest side of a target [m]. A vessel of which the inner side was seen is larger by
/// its wall, of which one view shows no more than the bounds.
double size_of(const Target& target) {
  Eigen::Vector3d sizes = target.body.bounds_Q().sizes();
  if (target.shell && target.shell->seen_inside) {
    sizes.head<2>().array() += target.shell->wall.min + target.shell->wall.max;
  }
  return sizes.maxCoeff();
}

/// Returns the distance from the body's bounds. It is negative if the body contains the point, and
/// the more so the nearer the body's centre is.
double distance(const Target& target, const Eigen::Vector3d& p_C) {
  const double outside = target.body.bounds_Q().exteriorDistance(target.body.X_CQ.inverse() * p_C);
  const double off = (target.body.centre_C() - p_C).norm();
  return outside > 0.0 ? outside : off - size_of(target);
}

/// Lists the targets that there are, by their ids.
std::string list_ids(const std::vector<const Target*>& targets) {
  std::ostringstream text;
  text << "there are:";
  for (const Target* target : targets) text << ' ' << target->id;
  return text.str();
}

/// Returns true if one of the ids is that of the target or of its body, or if any may be.
bool has_asked_id(const GraspQuery& query, const Target& target) {
  return allows(query.ids, target.id) || allows(query.ids, target.body_id);
}

/// Returns true if one of the tracks is that of the target or of its body, or if any may be.
bool has_asked_track(const GraspQuery& query, const Target& target) {
  return allows(query.tracks, target.track) || allows(query.tracks, target.body_track) ||
         allows(query.tracks, target.main_track);
}

/// Lists the tracks of the targets that have one and of their bodies, each once.
std::string list_tracks(const std::vector<const Target*>& targets) {
  std::set<int> tracks;
  for (const Target* target : targets) {
    for (const int track : {target->track, target->body_track}) {
      if (track > 0) tracks.insert(track);
    }
  }
  if (tracks.empty()) return "none of the targets has a track";
  std::ostringstream text;
  text << "there are the tracks:";
  for (const int track : tracks) text << ' ' << track;
  return text.str();
}

/// The conditions on a single target, each with its name.
struct Condition {
  const char* name;
  bool (*holds)(const GraspQuery& query, const Target& target);
  /// Lists what could have been asked for instead.
  std::string (*list)(const std::vector<const Target*>& targets) = list_ids;
};

const Condition kConditions[] = {
    {"of that id", has_asked_id},
    {"of that track", has_asked_track, list_tracks},
    {"of that type", [](const GraspQuery& q, const Target& t) { return allows(q.types, t.type); }},
    {"in that region",
     [](const GraspQuery& q, const Target& t) {
       return !q.region || lies_in(*q.region, t.body.centre_C());
     }},
    {"of that size",
     [](const GraspQuery& q, const Target& t) {
       return size_of(t) >= q.min_size && size_of(t) <= q.max_size;
     }},
};

bool holds_all(const GraspQuery& query, const Target& target) {
  return std::all_of(std::begin(kConditions), std::end(kConditions),
                     [&](const Condition& c) { return c.holds(query, target); });
}

}  // namespace

std::vector<const Target*> asked_for(const GraspQuery& query, const std::vector<Target>& targets) {
  std::vector<const Target*> asked;
  for (const Target& target : targets) {
    if (target.wanted && holds_all(query, target)) asked.push_back(&target);
  }
  if (!query.near_C || asked.empty()) return asked;
  const Target* const nearest =
      *std::min_element(asked.begin(), asked.end(), [&](const Target* a, const Target* b) {
        return distance(*a, *query.near_C) < distance(*b, *query.near_C);
      });
  const int id = name_of(*nearest, query).id;
  std::erase_if(asked, [&](const Target* target) { return name_of(*target, query).id != id; });
  return asked;
}

std::vector<std::string> missed_ids(const GraspQuery& query, const std::vector<Target>& targets,
                                    const std::map<int, std::string>& why_none) {
  std::vector<std::string> sentences;
  for (const int id : query.ids) {
    const bool is_target = std::any_of(targets.begin(), targets.end(), [&](const Target& t) {
      return t.wanted && (t.id == id || t.body_id == id);
    });
    if (is_target) continue;
    const auto known = why_none.find(id);
    sentences.push_back("target " + std::to_string(id) + " " +
                        (known == why_none.end() ? "was not found" : known->second));
  }
  return sentences;
}

std::string why_none(const GraspQuery& query, const std::vector<Target>& targets) {
  std::vector<const Target*> left;
  for (const Target& target : targets) {
    if (target.wanted) left.push_back(&target);
  }
  if (left.empty()) return "nothing that the hand could hold was found";
  for (const Condition& condition : kConditions) {
    const std::vector<const Target*> before = left;
    std::erase_if(left, [&](const Target* t) { return !condition.holds(query, *t); });
    if (!left.empty()) continue;
    return std::string("no target ") + condition.name + "; " + condition.list(before);
  }
  return {};
}

}  // namespace quadrille
