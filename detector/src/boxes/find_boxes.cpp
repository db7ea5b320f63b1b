#include "boxes/find_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <optional>
#include <utility>

#include "boxes/box_axes.hpp"
#include "boxes/box_draft.hpp"
#include "boxes/box_ends.hpp"
#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"
#include "boxes/grouping.hpp"
#include "boxes/measure_box.hpp"
#include "boxes/missing_face.hpp"
#include "cloud/far_cloud.hpp"
#include "cloud/some_points.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille {
namespace {

/// Detections may come from messages, so their fields are checked.
bool is_sound(const Detection& plane) {
  const Eigen::Vector3d size = plane.extent_Q.sizes();
  return plane.X_CQ.matrix().allFinite() && plane.X_CQ.linear().isUnitary(1e-3) &&
         size.allFinite() && plane.extent_Q.center().allFinite() && size.head<2>().minCoeff() > 0.0;
}

/// Makes boxes, beginning with those of most faces, and uses each piece of a plane for one box
/// only.
class BoxMaker {
 public:
  BoxMaker(const DirectionIndex& sight, const std::vector<Detection>& detections,
           const std::vector<FlatPatch>& patches)
      : sight_(sight) {
    for (const Detection& d : detections) {
      last_id_ = std::max(last_id_, d.id);
      if (d.type != QuadricType::kPlane || !is_sound(d)) continue;
      planes_.push_back(&d);
      if (d.extent_Q.sizes().maxCoeff() > kMaxSide) continue;
      for (Face& face : faces_of(d, sight_)) faces_.push_back(std::move(face));
    }
    for (const FlatPatch& flat : patches) {
      if (is_known(flat.patch)) continue;
      if (auto face = draft_face(flat, sight_)) faces_.push_back(std::move(*face));
    }
    finish_drafts();
  }

  std::vector<Box> make() {
    for (const std::vector<int>& group : group_faces(faces_)) {
      std::vector<const Face*> faces;
      faces.reserve(group.size());
      for (const int i : group) faces.push_back(&faces_[i]);
      add(faces);
    }
    for (const Face& face : faces_) {
      const bool detected = face.id != 0;
      if (!detected || !is_free(&face)) continue;
      const BoxDraft draft = draft_of({&face}, sight_);
      if (is_rectangular(draft)) add({&face}, &draft);
    }
    return std::move(boxes_);
  }

 private:
  /// Finishes those drafts that may belong to a box, and drops the others: an undetected face makes
  /// no box alone.
  void finish_drafts() {
    std::vector<char> grouped(faces_.size(), 0);
    for (const std::vector<int>& group : group_faces(faces_)) {
      for (const int i : group) grouped[i] = 1;
    }
    std::vector<Face> faces;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (!faces_[i].is_patch) {
        faces.push_back(std::move(faces_[i]));
      } else if (grouped[i]) {
        if (auto face = finished_face(faces_[i], sight_)) faces.push_back(std::move(*face));
      }
    }
    faces_ = std::move(faces);
  }

  /// True if a face that was found before already covers the middle of the patch.
  bool is_known(const FacePatch& patch) const {
    const Eigen::Vector3d middle_C = patch.X_CP.translation();
    return std::any_of(faces_.begin(), faces_.end(), [&](const Face& face) {
      return face.n_C.dot(patch.X_CP.linear().col(2)) > std::cos(2.0 * kMaxSkew) &&
             std::abs(face.height(middle_C)) < kRounding &&
             (middle_C - face.middle_C).norm() < face.radius;
    });
  }

  /// False for a face whose middle lies on a box: it is a second fit of one of the box's own faces.
  bool is_free(const Face* face) const {
    return std::none_of(boxes_.begin(), boxes_.end(), [&](const Box& box) {
      return box.outer_B.exteriorDistance(box.X_CB.inverse() * face->middle_C) < kRounding;
    });
  }

  /// Adds the box of some faces, if they make one.
  /// @param draft  of these faces; null if it is not known yet
  void add(const std::vector<const Face*>& faces, const BoxDraft* draft = nullptr) {
    if (!std::all_of(faces.begin(), faces.end(), [&](const Face* f) { return is_free(f); })) return;
    std::vector<const Detection*> others;
    for (const Detection* plane : planes_) {
      const auto same = [&](const Face* face) { return face->id == plane->id; };
      if (std::none_of(faces.begin(), faces.end(), same)) others.push_back(plane);
    }
    std::optional<Box> box = completed_box(faces, draft ? draft->R_CA : box_axes(faces), others);
    if (!box) box = measure_box(draft ? *draft : draft_of(faces, sight_), others);
    if (!box) return;
    if (last_id_ == std::numeric_limits<int>::max()) return;
    box->id = ++last_id_;
    boxes_.push_back(std::move(*box));
  }

  /// A box completed with faces that are not among the given ones; nullopt if there are none or
  /// they make no box.
  /// @param R_CA  axes of the given faces
  std::optional<Box> completed_box(std::vector<const Face*> faces, Eigen::Matrix3d R_CA,
                                   const std::vector<const Detection*>& others) const {
    const std::size_t given = faces.size();
    std::list<Face> missing;  // The list keeps pointers to its elements valid.
    while (faces.size() < 3) {
      std::optional<Face> face = find_missing_face(faces, R_CA, sight_);
      if (!face) break;
      faces.push_back(&missing.emplace_back(std::move(*face)));
      R_CA = box_axes(faces);
    }
    if (faces.size() == given) return std::nullopt;
    return measure_box(draft_of(faces, sight_), others);
  }

  const DirectionIndex& sight_;
  std::vector<const Detection*> planes_;
  std::vector<Face> faces_;
  std::vector<Box> boxes_;
  int last_id_ = 0;
};

}  // namespace

std::vector<Box> find_boxes(DirectionsOnDemand& directions,
                            const std::vector<Detection>& detections,
                            const std::vector<FlatPatch>& patches) {
  const bool has_plane = std::any_of(detections.begin(), detections.end(), [](const Detection& d) {
    return d.type == QuadricType::kPlane;
  });
  // Without a face there is no box, and the maker indexes the whole cloud before it looks for one.
  if (!has_plane && patches.empty()) return {};
  return BoxMaker(directions.index(), detections, patches).make();
}

std::vector<Box> find_boxes(const CloudView& given, const std::vector<Detection>& detections) {
  const RangeCheck range = check_range(given);
  const CloudView cloud = range.kept(given);
  const std::vector<Eigen::Vector3d> some = some_of(cloud.points);
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  if (!some.empty()) shift = shift_to_origin(middle_of(some));
  std::vector<Box> boxes;
  if (shift.isZero(0.0)) {
    DirectionsOnDemand directions(cloud, nullptr);
    boxes = find_boxes(directions, detections, {});
  } else {
    std::vector<Detection> shifted;
    shifted.reserve(detections.size());
    for (const Detection& d : detections) shifted.push_back(translated(d, shift));
    const PointCloud near = translated(cloud, shift);
    DirectionsOnDemand directions(near, nullptr);
    boxes = find_boxes(directions, shifted, {});
  }
  for (Box& box : boxes) box.X_CB = rounded(box.X_CB.pretranslate(-shift));
  return boxes;
}

}  // namespace quadrille
