#include "boxes/join_boxes.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace quadrille {
namespace {

/// True if the middle of one of two boxes lies in the other.
bool are_one(const Box& a, const Box& b) {
  return a.inner_B.contains(a.X_CB.inverse() * b.X_CB.translation()) ||
         b.inner_B.contains(b.X_CB.inverse() * a.X_CB.translation());
}

/// More of the sides of the first box are known.
bool is_better(const Box& a, const Box& b) {
  const auto sides = [](const Box& box) {
    return std::count(box.seen.begin(), box.seen.end(), true);
  };
  return std::make_tuple(sides(a), a.faces.size(), a.score) >
         std::make_tuple(sides(b), b.faces.size(), b.score);
}

}  // namespace

std::vector<Box> join_boxes(std::vector<std::vector<Box>> of_views) {
  if (of_views.size() == 1) return std::move(of_views.front());
  std::vector<Box> all, joined;
  for (std::vector<Box>& boxes : of_views) {
    std::move(boxes.begin(), boxes.end(), std::back_inserter(all));
  }
  if (all.empty()) return all;
  int id = std::min_element(all.begin(), all.end(), [](const Box& a, const Box& b) {
             return a.id < b.id;
           })->id;
  std::stable_sort(all.begin(), all.end(), is_better);
  for (Box& box : all) {
    const auto same = std::find_if(joined.begin(), joined.end(),
                                   [&](const Box& other) { return are_one(box, other); });
    if (same == joined.end()) {
      box.id = id++;
      joined.push_back(std::move(box));
      continue;
    }
    for (const int face : box.faces) {
      if (std::find(same->faces.begin(), same->faces.end(), face) == same->faces.end()) {
        same->faces.push_back(face);
      }
    }
  }
  return joined;
}

}  // namespace quadrille
