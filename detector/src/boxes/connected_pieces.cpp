#include "boxes/connected_pieces.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace quadrille {
namespace {

using Cell = std::pair<int, int>;

}  // namespace

std::vector<int> connected_pieces(const std::vector<Eigen::Vector2d>& places, double cell) {
  const auto cell_of = [&](const Eigen::Vector2d& place) {
    const Eigen::Vector2d at = (place / cell).array().floor();
    return Cell(static_cast<int>(at.x()), static_cast<int>(at.y()));
  };
  std::map<Cell, int> piece;
  for (const Eigen::Vector2d& place : places) piece.try_emplace(cell_of(place), -1);
  int next = 0;
  for (auto& [seed, number] : piece) {
    if (number >= 0) continue;
    number = next++;
    std::vector<Cell> open = {seed};
    while (!open.empty()) {
      const Cell at = open.back();
      open.pop_back();
      for (int n = 0; n < 9; ++n) {
        const auto found = piece.find({at.first + n % 3 - 1, at.second + n / 3 - 1});
        if (found == piece.end() || found->second >= 0) continue;
        found->second = number;
        open.push_back(found->first);
      }
    }
  }
  std::vector<int> numbers;
  for (const Eigen::Vector2d& place : places) numbers.push_back(piece.at(cell_of(place)));
  return numbers;
}

}  // namespace quadrille
