#include "quadrille/lasting_scene.hpp"

namespace quadrille {

std::vector<PointCloud> LastingScene::add(const InputCloud& input, const std::string& path,
                                          const RobotShapes& robot) {
  if (!memory_) return {};
  const bool logged = !input.channel.empty();
  const int number = static_cast<int>(cameras_.size());
  const int camera =
      cameras_.try_emplace({logged ? path : "", input.channel}, number).first->second;
  // Files have no time; their order is what counts.
  utime_ = logged ? input.utime : utime_ + 1;
  memory_->add(utime_, robot.taken_from(input.cloud), input.X_CK, camera);
  return memory_->others(utime_, input.X_CK, camera);
}

}  // namespace quadrille
