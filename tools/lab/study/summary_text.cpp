#include <fmt/format.h>

#include <functional>
#include <map>

#include "lab/study/summary.hpp"
#include "lab/study/wilson.hpp"

namespace quadrille::study {
namespace {

void add_types(const GroupSummary& group, std::vector<Figure>* figures) {
  std::map<std::string, Ratio> good, held;
  for (const FirstGrasp& first : group.first) {
    const std::string type = first.object_type.empty() ? "nothing" : first.object_type;
    good[type].counted += first.good;
    ++good[type].of;
    held[type].counted += first.held;
    held[type].of += first.tried;
  }
  for (const auto& [type, ratio] : good) {
    figures->push_back({fmt::format("- on {} good", type), ratio});
    if (held[type].of > 0) figures->push_back({fmt::format("- on {} held", type), held[type]});
  }
}

std::string line_of(const Figure& figure) {
  const Ratio& ratio = figure.ratio;
  if (ratio.of == 0) return fmt::format("  {:<32} none\n", figure.name);
  const Share share = wilson_share(ratio.counted, ratio.of);
  return fmt::format("  {:<32} {:>5} of {:>5} {:6.1f} %  ({:.1f} to {:.1f} %)\n", figure.name,
                     ratio.counted, ratio.of, 100.0 * share.value, 100.0 * share.low,
                     100.0 * share.high);
}

std::string group_text(const GroupSummary& group) {
  std::string text = fmt::format("{} ({}): {} scenes, {} grasps\n", group.name, group.settings,
                                 group.scenes, group.grasps);
  if (group.failed > 0) {
    text += fmt::format("  {} scenes could not be used; see the column error\n", group.failed);
  }
  if (group.without_truth > 0) {
    text += fmt::format("  {} scenes have no truth, and no part in what follows\n",
                        group.without_truth);
  }
  for (const Figure& figure : figures_of(group)) text += line_of(figure);
  return text;
}

using Choose = std::function<bool(const FirstGrasp&)>;

experiments::Plot score_plot(const std::string& title, const std::vector<GroupSummary>& groups,
                             const Choose& counts, const Choose& among) {
  constexpr int kSteps = 20;
  experiments::Plot plot;
  plot.title = title;
  plot.x_label = "least score";
  plot.y_label = "share [%]";
  plot.min_y_range = {0.0, 100.0};
  for (const GroupSummary& group : groups) {
    experiments::Series line;
    line.name = group.short_name;
    for (int k = 0; k <= kSteps; ++k) {
      const double least = static_cast<double>(k) / kSteps;
      Ratio ratio;
      for (const FirstGrasp& first : group.first) {
        if (first.score < least || !among(first)) continue;
        ++ratio.of;
        ratio.counted += counts(first);
      }
      if (ratio.of > 0) line.points.emplace_back(least, 100.0 * ratio.counted / ratio.of);
    }
    if (!line.points.empty()) plot.lines.push_back(std::move(line));
  }
  return plot;
}

}  // namespace

std::vector<Figure> figures_of(const GroupSummary& group) {
  if (group.without_truth + group.failed == group.scenes) return {};
  std::vector<Figure> figures = {{"objects with a grasp", group.objects_with_grasp},
                                 {"objects with a good first grasp", group.objects_with_good},
                                 {"objects with a held first grasp", group.objects_with_held},
                                 {"first grasps good", group.first_good},
                                 {"first grasps touching", group.first_touching},
                                 {"first grasps held", group.first_held}};
  add_types(group, &figures);
  figures.push_back({"all grasps good", group.all_good});
  figures.push_back({"all grasps touching", group.all_touching});
  figures.push_back({"grasps held of all tried", group.all_held});
  return figures;
}

std::array<std::string, 3> words_of(const Ratio& ratio) {
  if (ratio.of == 0) return {"none", "", ""};
  const Share share = wilson_share(ratio.counted, ratio.of);
  return {fmt::format("{} of {}", ratio.counted, ratio.of),
          fmt::format("{:.1f} %", 100.0 * share.value),
          fmt::format("{:.1f} to {:.1f} %", 100.0 * share.low, 100.0 * share.high)};
}

std::string summary_text(const std::vector<GroupSummary>& groups) {
  std::string text;
  for (const GroupSummary& group : groups) text += group_text(group) + '\n';
  if (text.empty()) return "no scenes\n";
  return text + "In brackets: Wilson's 95 % intervals.\n";
}

std::vector<experiments::Plot> score_plots(const std::vector<GroupSummary>& groups) {
  std::vector<experiments::Plot> plots = {score_plot(
      "First grasps that are good", groups, [](const FirstGrasp& first) { return first.good; },
      [](const FirstGrasp&) { return true; })};
  const experiments::Plot held = score_plot(
      "First grasps that were held", groups, [](const FirstGrasp& first) { return first.held; },
      [](const FirstGrasp& first) { return first.tried; });
  if (!held.lines.empty()) plots.push_back(held);
  return plots;
}

}  // namespace quadrille::study
