#include "boxes/find_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <list>
#include <optional>
#include <utility>

#include "base/mask.hpp"
#include "base/try_ahead.hpp"
#include "boxes/box_draft.hpp"
#include "boxes/box_ends.hpp"
#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"
#include "boxes/faces_box.hpp"
#include "boxes/find_faces.hpp"
#include "boxes/grouping.hpp"
#include "boxes/measure_box.hpp"
#include "cloud/far_cloud.hpp"
#include "cloud/some_points.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/parallel_for.hpp"

namespace quadrille {
namespace {

// Least cosine between the normal of a seed's face and the line of sight (11°): pixels that the
// sensor mixed at an outline lie along the lines of sight and look like an oblique face.
constexpr double kMinSeenCosine = 0.2;
// A face that a seed shows is the whole of a known one if that reaches no farther from its middle
// than this many times as far. A thing in pieces, such as an open box, shows parts of its walls.
constexpr double kMaxPart = 1.5;

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
           const BoxHints& hints, int threads)
      : sight_(sight), seeds_(hints.seeds), threads_(threads) {
    std::vector<const Detection*> small;
    for (const Detection& d : detections) {
      last_id_ = std::max(last_id_, d.id);
      if (d.type != QuadricType::kPlane || !is_sound(d)) continue;
      planes_.push_back(&d);
      if (d.extent_Q.sizes().maxCoeff() <= kMaxSide) small.push_back(&d);
    }
    std::vector<std::vector<Face>> faces(small.size());
    parallel_for(static_cast<int>(small.size()), threads_,
                 [&](int k) { faces[k] = faces_of(*small[k], sight_); });
    for (std::vector<Face>& of_plane : faces) {
      std::move(of_plane.begin(), of_plane.end(), std::back_inserter(faces_));
    }
    add_drafts(hints.patches);
    finish_drafts();
  }

  std::vector<Box> make() {
    for (const std::vector<int>& group : group_faces(faces_)) {
      std::vector<const Face*>& faces = groups_.emplace_back();
      faces.reserve(group.size());
      for (const int i : group) faces.push_back(&faces_[i]);
    }
    for (const Face& face : faces_) {
      if (face.id != 0) groups_.push_back({&face});
    }
    begun_.assign(groups_.size(), 0);
    take_steps(this, threads_);
    for (const BoxSeed& seed : seeds_) add(box_of_seed(seed));
    // A box of one face knows the least, so these come last.
    for (const Face& face : faces_) {
      if (face.id == 0 || !is_free(&face)) continue;
      add(box_of_upright_face(face, planes_beside({&face}), sight_));
    }
    return std::move(boxes_);
  }

  // Groups of faces are steps for take_steps(). Each makes a box or none, whatever the others make,
  // but only if its faces are free when it is its turn.
  struct State {};
  struct Scratch {};
  using Outcome = std::optional<Box>;
  static constexpr std::size_t kTriesPerThread = 2;

  State state() const { return {}; }
  Scratch scratch() const { return {}; }
  std::optional<int> first() {
    while (first_ < groups_.size() && !are_free(groups_[first_])) ++first_;
    return first_ < groups_.size() ? std::optional<int>(static_cast<int>(first_)) : std::nullopt;
  }
  std::optional<int> begin_next() {
    for (std::size_t k = first_; k < groups_.size(); ++k) {
      if (begun_[k] || !are_free(groups_[k])) continue;
      begun_[k] = 1;
      return static_cast<int>(k);
    }
    return std::nullopt;
  }
  bool is_left(int step) const {
    return static_cast<std::size_t>(step) >= first_ && are_free(groups_[step]);
  }
  Outcome attempt(int step, State /*same*/, Scratch* /*none*/) const {
    return box_of_faces(groups_[step], planes_beside(groups_[step]), sight_);
  }
  bool holds(int /*step*/, const Outcome& /*box*/) const { return true; }
  bool take(int step, Outcome box) {
    first_ = static_cast<std::size_t>(step) + 1;
    return add(std::move(box));
  }

 private:
  /// Numbers a box and adds it; false if there is none.
  bool add(std::optional<Box> box) {
    if (!box || last_id_ == std::numeric_limits<int>::max()) return false;
    box->id = ++last_id_;
    boxes_.push_back(std::move(*box));
    return true;
  }

  /// Drafts the patches that no face covers, not even the draft of a patch before.
  void add_drafts(const std::vector<FlatPatch>& patches) {
    std::vector<std::optional<Face>> drafts(patches.size());
    const auto draft = [&](std::size_t k) { drafts[k] = draft_face(patches[k], sight_); };
    // Several threads also draft what the draft of an earlier patch will cover.
    const bool ahead = threads_ > 1;
    if (ahead) {
      parallel_for(static_cast<int>(patches.size()), threads_, [&](int k) {
        if (!is_known(patches[k].patch)) draft(k);
      });
    }
    for (std::size_t k = 0; k < patches.size(); ++k) {
      if (is_known(patches[k].patch)) continue;
      if (!ahead) draft(k);
      // A patch beside a known face may grow onto it; then it is a second fit of that face.
      if (drafts[k] && !is_known(drafts[k]->middle_C, drafts[k]->n_C)) {
        faces_.push_back(std::move(*drafts[k]));
      }
    }
  }

  /// Finishes those drafts that may belong to a box, and drops the others: an undetected face makes
  /// no box alone.
  void finish_drafts() {
    std::vector<char> grouped(faces_.size(), 0);
    for (const std::vector<int>& group : group_faces(faces_)) {
      for (const int i : group) grouped[i] = 1;
    }
    std::vector<std::optional<Face>> finished(faces_.size());
    parallel_for(static_cast<int>(faces_.size()), threads_, [&](int i) {
      if (!faces_[i].is_patch) {
        finished[i] = std::move(faces_[i]);
      } else if (grouped[i]) {
        finished[i] = finished_face(faces_[i], sight_);
      }
    });
    faces_.clear();
    for (std::optional<Face>& face : finished) {
      if (face) faces_.push_back(std::move(*face));
    }
  }

  /// True if a face that was found before already covers the middle of a patch.
  bool is_known(const FacePatch& patch) const {
    return is_known(patch.X_CP.translation(), patch.X_CP.linear().col(2));
  }
  bool is_known(const Eigen::Vector3d& middle_C, const Eigen::Vector3d& n_C) const {
    return known_face(middle_C, n_C) != faces_.end();
  }

  /// The face found before that covers a point and faces almost the same way.
  std::vector<Face>::const_iterator known_face(const Eigen::Vector3d& middle_C,
                                               const Eigen::Vector3d& n_C) const {
    return std::find_if(faces_.begin(), faces_.end(), [&](const Face& face) {
      return face.n_C.dot(n_C) > std::cos(2.0 * kMaxSkew) &&
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

  bool are_free(const std::vector<const Face*>& faces) const {
    return std::all_of(faces.begin(), faces.end(), [&](const Face* f) { return is_free(f); });
  }

  /// All detected planes except some faces.
  std::vector<const Detection*> planes_beside(const std::vector<const Face*>& faces) const {
    std::vector<const Detection*> others;
    for (const Detection* plane : planes_) {
      const auto same = [&](const Face* face) { return face->id == plane->id; };
      if (std::none_of(faces.begin(), faces.end(), same)) others.push_back(plane);
    }
    return others;
  }

  /// The box of those faces of a seed that are flat, free and meet at right angles, if there are
  /// two at least.
  std::optional<Box> box_of_seed(const BoxSeed& seed) const {
    std::list<Face> found;  // The list keeps pointers to its elements valid.
    std::vector<const Face*> faces;
    for (const FlatPatch& patch : seed) {
      std::optional<Face> face = face_of_seed(patch);
      const auto meets = [&](const Face* other) {
        return at_right_angles(*other, *face) && share_edge(*other, *face);
      };
      if (!face || !is_free(&*face) || !std::all_of(faces.begin(), faces.end(), meets)) continue;
      faces.push_back(&found.emplace_back(std::move(*face)));
    }
    if (faces.size() < 2) return std::nullopt;
    return measure_box(draft_of(faces, sight_), planes_beside(faces));
  }

  /// The face at a side of a seed; nullopt if there is none, or if it is only a part of a known
  /// one.
  std::optional<Face> face_of_seed(const FlatPatch& patch) const {
    std::optional<Face> face = unbent_face_at(patch, sight_);
    if (!face || face->cosine < kMinSeenCosine) return std::nullopt;
    const auto known = known_face(face->middle_C, face->n_C);
    if (known == faces_.end()) return face;
    if (known->radius > kMaxPart * face->radius) return std::nullopt;
    face->id = known->id;
    face->score = known->score;
    return face;
  }

  const DirectionIndex& sight_;
  const std::vector<BoxSeed>& seeds_;
  int threads_;
  std::vector<const Detection*> planes_;
  std::vector<Face> faces_;
  /// Faces that may make a box, in the order in which they are tried; the first of them that may be
  /// left; and those whose try has begun.
  std::vector<std::vector<const Face*>> groups_;
  std::size_t first_ = 0;
  Mask begun_;
  std::vector<Box> boxes_;
  int last_id_ = 0;
};

}  // namespace

std::vector<Box> find_boxes(DirectionsOnDemand& directions,
                            const std::vector<Detection>& detections, const BoxHints& hints,
                            int threads) {
  const bool has_plane = std::any_of(detections.begin(), detections.end(), [](const Detection& d) {
    return d.type == QuadricType::kPlane;
  });
  // Without a face there is no box, and the maker indexes the whole cloud before it looks for one.
  if (!has_plane && hints.patches.empty() && hints.seeds.empty()) return {};
  return BoxMaker(directions.index(), detections, hints, threads).make();
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
