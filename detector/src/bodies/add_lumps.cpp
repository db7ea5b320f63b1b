#include "bodies/add_lumps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "bodies/lumps.hpp"
#include "boxes/face.hpp"
#include "samples/convex_pieces.hpp"

namespace quadrille {
namespace {

class LumpAdder {
 public:
  LumpAdder(const BodySources& found, const std::vector<Support>& supports, int last_id,
            std::vector<SceneBody>* bodies)
      : found_(found), supports_(supports), last_id_(last_id), bodies_(bodies) {}

  void add() {
    const std::vector<Support> level = level_supports();
    const Mask open = open_samples(found_.samples, found_.owner, found_.boxes);
    for (const std::vector<int>& connected : connected_pieces(found_.samples, open)) {
      const std::map<int, int> contacts = contacts_of(connected);
      if (joined_a_body(connected, contacts)) continue;
      const Support* support = lump_support(found_.samples, connected, level, contacts.empty());
      if (support == nullptr) continue;
      const Mask above = above_support(found_.samples, connected, *support);
      for (const std::vector<int>& whole : connected_pieces(found_.samples, above)) {
        for (const std::vector<int>& piece : convex_pieces(found_.samples, whole)) {
          add_piece(piece, *support);
        }
      }
    }
  }

 private:
  void add_piece(const std::vector<int>& piece, const Support& support) {
    if (joined_a_body(piece, contacts_of(piece))) return;
    auto lump = lump_of(found_.samples, piece, support);
    if (!lump) return;
    lump->points = points_of(piece);
    lump->id = ++last_id_;
    bodies_->push_back(std::move(*lump));
  }

  int points_of(const std::vector<int>& piece) const {
    int points = 0;
    for (const int i : piece) points += found_.samples.count[i];
    return points;
  }

  /// Gives a piece to the body that it touches, if that is larger.
  bool joined_a_body(const std::vector<int>& piece, const std::map<int, int>& contacts) {
    SceneBody* host = host_of(contacts);
    const int points = points_of(piece);
    if (host == nullptr || host->points <= points) return false;
    host->points += points;
    return true;
  }

  /// The supports that are parallel to the one on which most bodies stand, or to the largest one:
  /// nothing stands on walls.
  std::vector<Support> level_supports() const {
    if (supports_.empty()) return {};
    std::map<int, int> standing;
    for (const SceneBody& body : *bodies_) {
      if (body.standing_on) ++standing[*body.standing_on];
    }
    const Support* main = &supports_.front();
    for (const Support& support : supports_) {
      if (standing[support.id] > standing[main->id]) main = &support;
    }
    std::vector<Support> level;
    std::copy_if(supports_.begin(), supports_.end(), std::back_inserter(level),
                 [&](const Support& s) { return s.n_C.dot(main->n_C) > std::cos(kMaxSkew); });
    return level;
  }

  /// The number of neighbours that a piece of samples has on each detection, by its id.
  std::map<int, int> contacts_of(const std::vector<int>& piece) const {
    std::map<int, int> contacts;
    for (const int i : piece) {
      for (const int j : found_.samples.neighbours_of(i)) {
        if (found_.owner[j] > 0) ++contacts[found_.owner[j]];
      }
    }
    return contacts;
  }

  /// The body that most of these contacts touch; nullptr if there is none.
  SceneBody* host_of(const std::map<int, int>& contacts) {
    const auto most =
        std::max_element(contacts.begin(), contacts.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == contacts.end()) return nullptr;
    const auto host = std::find_if(bodies_->begin(), bodies_->end(), [&](const SceneBody& body) {
      return std::find(body.parts.begin(), body.parts.end(), most->first) != body.parts.end();
    });
    return host == bodies_->end() ? nullptr : &*host;
  }

  const BodySources& found_;
  const std::vector<Support>& supports_;
  int last_id_;
  std::vector<SceneBody>* bodies_;
};

}  // namespace

void add_lumps(const BodySources& found, const std::vector<Support>& supports, int last_id,
               std::vector<SceneBody>* bodies) {
  LumpAdder(found, supports, last_id, bodies).add();
}

}  // namespace quadrille
