#pragma once

namespace quadrille {

/// One local maximum of the votes.
struct VotePeak {
  double lambda = 0.0;
  double votes = 0.0;
};

}  // namespace quadrille
