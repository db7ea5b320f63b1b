#include "lab/experiments/samplers.hpp"

#include <array>

#include "fits/compact_fit.hpp"
#include "fits/taubin_fit.hpp"
#include "search/basis.hpp"
#include "search/vote.hpp"
#include "search/web_vote.hpp"

namespace quadrille::experiments {
namespace {

// As in hypotheses.cpp.
constexpr double kMaxInconsistent = 0.6, kNormalNoise = 0.05;

OrientedPointsd random_tuple(const Neighbourhood& from, int count, RandomStream& random) {
  OrientedPointsd tuple(count);
  for (int i = 0; i < count; ++i) {
    const int k = random.below(static_cast<int>(from.points.size()));
    tuple.points.col(i) = from.points.points.col(k);
    tuple.normals.col(i) = from.points.normals.col(k);
  }
  return tuple;
}

VoteOptions vote_options() {
  VoteOptions options;
  options.min_height = 0.1;
  options.min_cosine = kSamplerCosine;
  return options;
}

void vote_with_three(const Neighbourhood& from, const OrientedPointsf& voters, bool check,
                     RandomStream& random, std::vector<Quadric>* hypotheses) {
  std::array<OrientedPoint, 3> basis;
  for (OrientedPoint& point : basis) {
    point = from.points.at(random.below(static_cast<int>(from.points.size())));
  }
  const auto pencil = make_pencil(basis);
  if (!pencil || (check && inconsistency(basis) > kMaxInconsistent)) return;
  for (const VotePeak& peak : vote(*pencil, voters, vote_options())) {
    hypotheses->emplace_back(pencil->at(peak.lambda));
  }
}

void vote_with_two(const Neighbourhood& from, const OrientedPointsf& voters, RandomStream& random,
                   std::vector<Quadric>* hypotheses) {
  std::array<OrientedPoint, 2> basis;
  for (OrientedPoint& point : basis) {
    point = from.points.at(random.below(static_cast<int>(from.points.size())));
  }
  const auto web = make_web(basis, kNormalNoise);
  if (!web) return;
  for (const WebPeak& peak : vote(*web, voters, vote_options())) {
    hypotheses->emplace_back(web->at(peak.lambda));
  }
}

template <class Fit>
Sampler tuple_sampler(const std::string& name, int count, Fit fit) {
  return {name, [count, fit](const Neighbourhood& from, const OrientedPointsf&,
                             RandomStream& random, std::vector<Quadric>* hypotheses) {
            const auto Q = fit(random_tuple(from, count, random));
            if (Q) hypotheses->push_back(*Q);
          }};
}

}  // namespace

std::vector<Sampler> all_samplers() {
  using P = const OrientedPointsd&;
  const auto three = [](bool check) {
    return [check](const Neighbourhood& from, const OrientedPointsf& voters, RandomStream& random,
                   std::vector<Quadric>* hypotheses) {
      vote_with_three(from, voters, check, random, hypotheses);
    };
  };
  return {
      {kThreeName, three(true)},
      {"3 points, vote", three(false)},
      {"2 points, vote in 3 dimensions", vote_with_two},
      tuple_sampler("4 points, compact", 4, [](P p) { return fit_compact(p); }),
      tuple_sampler("4 points, closed form", 4, [](P p) { return fit_three_and_one(p); }),
      tuple_sampler("9 points, Taubin", 9, [](P p) { return fit_taubin(p); }),
  };
}

}  // namespace quadrille::experiments
