#pragma once

#include <map>
#include <vector>

namespace quadrille::scoring {

/// For each finding, the surfaces that it may be, and how well it covers each.
using Candidates = std::map<int, std::map<int, double>>;

/// Pairs findings with surfaces one to one, as many as possible; better pairs are tried first.
/// @return the finding of each surface that has one
std::map<int, int> match_most(const Candidates& candidates);

}  // namespace quadrille::scoring
