#include "quadrille/remembered_frames.hpp"

#include <utility>

#include "poses/cloud_frame.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille {

RememberedFrames::RememberedFrames(std::string path, const InputArguments& inputs,
                                   const DetectorOptions& options)
    : path_(std::move(path)), inputs_(inputs), options_(options) {}

const RememberedFrame* RememberedFrames::at(std::size_t number) {
  if (!run_ || number + 1 < run_->read) {
    run_ = std::make_unique<Run>(path_, inputs_, options_);
  }
  while (run_->read <= number) {
    if (!read_next()) return nullptr;
  }
  return &run_->last;
}

/// Works on the next cloud of the log; false at its end.
bool RememberedFrames::read_next() {
  auto cloud = read_logged_cloud(run_->reader, path_, inputs_, static_cast<int>(run_->read) + 1);
  if (!cloud) {
    run_.reset();
    return false;
  }
  ++run_->read;
  RememberedFrame& frame = run_->last;
  frame.cloud = std::move(*cloud);
  frame.views.clear();
  InputCloud& input = frame.cloud.input;
  if (!frame.cloud.lack.empty()) {
    input.cloud.frame = to_string(CloudFrame::kCamera);
    frame.found = detect(input.robot.taken_from(input.cloud), options_);
    return true;
  }
  frame.found = run_->scene.detect(&input, path_, input.robot, &frame.views);
  run_->tracking.add_to(input, path_, &frame.found);
  frame.path.emplace_back(input.X_CK.translation().cast<float>());
  return true;
}

}  // namespace quadrille
