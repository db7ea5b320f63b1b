#include "lab/bench/bench.hpp"

#include <cmath>
#include <map>
#include <tuple>

#include "lab/experiments/measure.hpp"

namespace quadrille::bench {
namespace {

/// Collects the rows, ordered by family, then by the type that is counted, then by contender.
class Rows {
 public:
  void add(const Frame& frame, int family, const std::string& counted, int contender,
           const Contender& who, const Outcome& outcome) {
    Row& row = rows_[{family, counted, contender}];
    row.family = frame.family;
    row.contender = who.name;
    row.counted = counted;
    row.finds_others = !counted.empty() && who.only.empty();
    ++row.frames;
    FrameScore one = scoring::score(frame, outcome.findings, counted);
    // Contenders that look for one type or get no planes are not judged on planes.
    if (!counted.empty() || who.given_objects) {
      one.planes_wanted = one.planes_found = one.planes_right = one.planes_wrong = 0;
    }
    row.total += one;
    row.wall_ms.push_back(outcome.wall_ms);
    row.cpu_ms.push_back(outcome.cpu_ms);
  }

  std::vector<Row> list() const {
    std::vector<Row> list;
    for (const auto& [key, row] : rows_) list.push_back(row);
    return list;
  }

 private:
  std::map<std::tuple<int, std::string, int>, Row> rows_;
};

void run_on(const Frame& frame, int family, const std::vector<Contender>& contenders, Rows* rows) {
  for (int k = 0; k < static_cast<int>(contenders.size()); ++k) {
    const Contender& contender = contenders[k];
    if (!contender.absent.empty()) continue;
    const Outcome outcome = contender.run(frame);
    if (contender.only.empty()) rows->add(frame, family, "", k, contender, outcome);
    rows->add(frame, family, "sphere", k, contender, outcome);
  }
}

}  // namespace

double Row::precision() const { return finds_others ? std::nan("") : total.precision(); }

double Row::width_error() const {
  return total.width_errors.empty() ? std::nan("") : experiments::quantile(total.width_errors, 0.5);
}

double Row::distance() const {
  return total.distances.empty() ? std::nan("") : experiments::quantile(total.distances, 0.5);
}

std::vector<Row> run_bench(const std::vector<Contender>& contenders, const FrameOptions& frames) {
  Rows rows;
  for_each_frame(frames,
                 [&](const Frame& frame, int family) { run_on(frame, family, contenders, &rows); });
  return rows.list();
}

}  // namespace quadrille::bench
