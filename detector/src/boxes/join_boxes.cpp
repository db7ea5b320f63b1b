#include "boxes/join_boxes.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace quadrille {
namespace {

/// True if two boxes occupy the same place: the middle of each lies in the other.
bool are_one(const Box& a, const Box& b) {
  return a.outer_B.contains(a.X_CB.inverse() * b.X_CB.translation()) &&
         b.outer_B.contains(b.X_CB.inverse() * a.X_CB.translation());
}

/// A box, and the views that show it.
struct SeenBox {
  Box box;
  std::vector<std::size_t> views;

  bool is_seen_in(std::size_t view) const {
    return std::find(views.begin(), views.end(), view) != views.end();
  }
};

/// More of the sides of the first box are known.
bool is_better(const SeenBox& a, const SeenBox& b) {
  const auto sides = [](const Box& box) {
    return std::count(box.seen.begin(), box.seen.end(), true);
  };
  return std::make_tuple(sides(a.box), a.box.faces.size(), a.box.score) >
         std::make_tuple(sides(b.box), b.box.faces.size(), b.box.score);
}

/// Adds the faces and views of a box to those of the same box in another view.
void add(const SeenBox& more, SeenBox* same) {
  same->views.insert(same->views.end(), more.views.begin(), more.views.end());
  for (const int face : more.box.faces) {
    std::vector<int>& faces = same->box.faces;
    if (std::find(faces.begin(), faces.end(), face) == faces.end()) faces.push_back(face);
  }
}

}  // namespace

std::vector<Box> join_boxes(std::vector<std::vector<Box>> of_views) {
  // A single view has nothing to join, and its order is kept.
  if (of_views.size() == 1) return std::move(of_views.front());
  std::vector<SeenBox> all, joined;
  for (std::size_t v = 0; v < of_views.size(); ++v) {
    for (Box& box : of_views[v]) all.push_back({std::move(box), {v}});
  }
  int id = std::numeric_limits<int>::max();
  for (const SeenBox& seen : all) id = std::min(id, seen.box.id);
  std::stable_sort(all.begin(), all.end(), is_better);
  for (SeenBox& seen : all) {
    // Two boxes of one view are different, since it shows both.
    const auto same = std::find_if(joined.begin(), joined.end(), [&](const SeenBox& other) {
      return !other.is_seen_in(seen.views.front()) && are_one(seen.box, other.box);
    });
    if (same != joined.end()) {
      add(seen, &*same);
    } else {
      seen.box.id = id++;
      joined.push_back(std::move(seen));
    }
  }
  std::vector<Box> boxes;
  boxes.reserve(joined.size());
  for (SeenBox& seen : joined) boxes.push_back(std::move(seen.box));
  return boxes;
}

}  // namespace quadrille
