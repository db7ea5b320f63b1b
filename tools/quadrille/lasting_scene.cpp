#include "quadrille/lasting_scene.hpp"

namespace quadrille {

DetectionResult LastingScene::detect(InputCloud* input, const std::string& path,
                                     const RobotShapes& robot, std::vector<PointCloud>* views) {
  const bool logged = !input->channel.empty();
  const int number = static_cast<int>(cameras_.size());
  const int camera =
      cameras_.try_emplace({logged ? path : "", input->channel}, number).first->second;
  // Files have no time; their order is what counts.
  utime_ = logged ? input->utime : utime_ + 1;
  const PointCloud cloud = robot.taken_from(input->cloud);
  if (memory_) {
    memory_->add(utime_, cloud, input->X_CK, camera);
    *views = memory_->others(utime_, input->X_CK, camera);
  }
  DetectionResult found = detector_->detect(utime_, cloud, input->X_CK, camera);
  input->X_CK = detector_->correction(camera) * input->X_CK;
  return found;
}

}  // namespace quadrille
