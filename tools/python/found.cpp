#include "python/found.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille::python {
namespace {

/// Notes the ids of things, and finds free ones.
class Ids {
 public:
  /// @param list, n  what the thing is called in errors, such as detections[2]
  void note(int id, const char* list, std::size_t n) {
    const auto refuse = [&](const std::string& why) {
      throw std::invalid_argument(std::string(list) + "[" + std::to_string(n) + "]: the id " +
                                  std::to_string(id) + why + "; 0 stands for the next free one");
    };
    if (id < 0 || id > kMaxId) {
      refuse(" is not between 1 and " + std::to_string(kMaxId));
    }
    if (id != 0 && !used_.insert(id).second) refuse(" occurs twice");
    last_ = std::max(last_, id);
  }
  /// Numbers of what is found but not reported are below 0.
  void skip(int id) { last_ = std::max({last_, id, -id}); }
  int next() { return ++last_; }

 private:
  static constexpr int kMaxId = 1 << 30;
  std::set<int> used_;
  int last_ = 0;
};

/// Gives the next free numbers to what has the id 0.
void number(std::vector<Detection>* detections, std::vector<Box>* boxes, Ids* ids) {
  for (std::size_t n = 0; n < detections->size(); ++n) {
    ids->note((*detections)[n].id, "detections", n);
  }
  for (std::size_t n = 0; n < boxes->size(); ++n) ids->note((*boxes)[n].id, "boxes", n);
  for (Detection& d : *detections) d.id = d.id == 0 ? ids->next() : d.id;
  for (Box& box : *boxes) box.id = box.id == 0 ? ids->next() : box.id;
}

}  // namespace

DetectionResult Found::in(const Eigen::Isometry3d& X_CF) const {
  if (X_CF.matrix() == X_CK.matrix()) return in_K;
  const Eigen::Isometry3d X_FK = X_CF.inverse() * X_CK;
  DetectionResult there = in_K;
  there.detections = moved(std::move(there.detections), X_FK);
  there.boxes = moved(std::move(there.boxes), X_FK);
  there.bodies = moved(std::move(there.bodies), X_FK);
  return there;
}

Found found_of(std::vector<Detection> detections, std::vector<Box> boxes,
               std::vector<SceneBody> bodies) {
  Ids ids;
  // A body may have the number of its part, and a box has those of its faces.
  for (const SceneBody& body : bodies) ids.skip(body.id);
  for (const Box& box : boxes) {
    for (const int face : box.faces) ids.skip(face);
  }
  number(&detections, &boxes, &ids);
  Found found;
  found.in_K.detections = std::move(detections);
  found.in_K.boxes = std::move(boxes);
  found.in_K.bodies = std::move(bodies);
  return found;
}

Found with_known(Found found, std::vector<Detection> detections, std::vector<Box> boxes) {
  const DetectionResult& in_K = found.in_K;
  Ids ids;
  for (const SceneBody& body : in_K.bodies) ids.skip(body.id);
  for (const Detection& d : in_K.detections) ids.skip(d.id);
  for (const Box& box : in_K.boxes) ids.skip(box.id);
  for (Detection& d : detections) d.id = 0;
  for (Box& box : boxes) box.id = 0;
  number(&detections, &boxes, &ids);
  const Eigen::Isometry3d X_KC = found.X_CK.inverse();
  for (Detection& d : moved(std::move(detections), X_KC)) {
    found.in_K.detections.push_back(std::move(d));
  }
  for (Box& box : moved(std::move(boxes), X_KC)) found.in_K.boxes.push_back(std::move(box));
  return found;
}

}  // namespace quadrille::python
