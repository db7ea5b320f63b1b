#include "python/found.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille::python {
namespace {

/// Notes the ids of things, and finds free ones.
class Ids {
 public:
  void note(int id) {
    if (id != 0 && !used_.insert(id).second) {
      throw std::invalid_argument("the id " + std::to_string(id) +
                                  " occurs twice; 0 stands for the next free one");
    }
    last_ = std::max(last_, id);
  }
  void skip(int id) { last_ = std::max(last_, id); }
  int next() { return ++last_; }

 private:
  std::set<int> used_;
  int last_ = 0;
};

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
  for (const Detection& d : detections) ids.note(d.id);
  for (const Box& box : boxes) ids.note(box.id);
  // A body may have the number of its part.
  for (const SceneBody& body : bodies) ids.skip(body.id);
  for (Detection& d : detections) d.id = d.id == 0 ? ids.next() : d.id;
  for (Box& box : boxes) box.id = box.id == 0 ? ids.next() : box.id;
  Found found;
  found.in_K.detections = std::move(detections);
  found.in_K.boxes = std::move(boxes);
  found.in_K.bodies = std::move(bodies);
  return found;
}

}  // namespace quadrille::python
