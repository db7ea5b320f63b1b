#include "quadrille/lasting_scene.hpp"

namespace quadrille {

std::vector<PointCloud> LastingScene::add(const InputCloud& input, const RobotShapes& robot) {
  if (!memory_) return {};
  // Files have no time; their order is what counts.
  const std::int64_t utime = input.channel.empty() ? ++files_ : input.utime;
  memory_->add(utime, robot.taken_from(input.cloud), input.X_CK);
  return memory_->others(utime, input.X_CK);
}

}  // namespace quadrille
