#pragma once

#include <array>

#include "quadrille/detector/setting.hpp"

namespace quadrille {

/// A frame in which clouds or results are given.
enum class CloudFrame {
  kCamera,  ///< K, the camera's frame: it looks along z from the origin
  kWorld,   ///< W, the fixed frame in which the camera's poses are given
};

constexpr auto words_of(CloudFrame) {
  return std::to_array<Word<CloudFrame>>(
      {{"camera", CloudFrame::kCamera}, {"world", CloudFrame::kWorld}});
}

}  // namespace quadrille
