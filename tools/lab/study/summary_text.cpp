#include <fmt/format.h>

#include <functional>
#include <map>

#include "lab/study/summary.hpp"
#include "lab/study/wilson.hpp"

namespace quadrille::study {
namespace {

std::string share_line(const std::string& name, const Ratio& ratio) {
  if (ratio.of == 0) return fmt::format("  {:<32} none\n", name);
  const Share share = wilson_share(ratio.counted, ratio.of);
  return fmt::format("  {:<32} {:>5} of {:>5} {:6.1f} %  ({:.1f} to {:.1f} %)\n", name,
                     ratio.counted, ratio.of, 100.0 * share.value, 100.0 * share.low,
                     100.0 * share.high);
}

std::string type_lines(const GroupSummary& group) {
  std::map<std::string, Ratio> good, held;
  for (const FirstGrasp& first : group.first) {
    const std::string type = first.object_type.empty() ? "nothing" : first.object_type;
    good[type].counted += first.good;
    ++good[type].of;
    held[type].counted += first.held;
    held[type].of += first.tried;
  }
  std::string text;
  for (const auto& [type, ratio] : good) {
    text += share_line(fmt::format("- on {} good", type), ratio);
    if (held[type].of > 0) text += share_line(fmt::format("- on {} held", type), held[type]);
  }
  return text;
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
  if (group.without_truth + group.failed == group.scenes) return text;
  text += share_line("objects with a grasp", group.objects_with_grasp);
  text += share_line("objects with a good first grasp", group.objects_with_good);
  text += share_line("objects with a held first grasp", group.objects_with_held);
  text += share_line("first grasps good", group.first_good);
  text += share_line("first grasps touching", group.first_touching);
  text += share_line("first grasps held", group.first_held);
  text += type_lines(group);
  text += share_line("all grasps good", group.all_good);
  text += share_line("all grasps touching", group.all_touching);
  return text + share_line("grasps held of all tried", group.all_held);
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
