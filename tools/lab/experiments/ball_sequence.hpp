#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/experiments/sphere_errors.hpp"

namespace quadrille::experiments {

/// A scan of a ball, and the ball's position in it [m].
struct BallFrame {
  /// Path of the cloud.
  std::string file;
  KnownSphere ball;
};

/// Successive scans of one ball.
struct BallSequence {
  std::string name;
  std::vector<BallFrame> frames;
};

/// Returns the folder of the real scans: data/real in $QUADRILLE_DATA, or in ../shared.
std::filesystem::path real_scans();

/// Reads the sequences that manifest.json in a folder of real scans lists, each with at least one
/// frame. The ball has one radius in all frames of a sequence, the median of the annotated ones.
/// @throws io::FileError if there is no manifest, if it is broken or lists no sequence
std::vector<BallSequence> read_sequences(const std::filesystem::path& folder);

}  // namespace quadrille::experiments
