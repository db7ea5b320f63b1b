#pragma once

#include <map>
#include <vector>

namespace quadrille::scoring {

/// For each finding the surfaces that it may be, with how well it covers them.
using Candidates = std::map<int, std::map<int, double>>;

/// Pairs findings with surfaces, one to one and as many as can be; better pairs are tried first.
/// @return the finding of each surface that has one
std::map<int, int> match_most(const Candidates& candidates);

}  // namespace quadrille::scoring
