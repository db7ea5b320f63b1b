#include "io/settings/setting_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "quadrille/detector/printable.hpp"

namespace quadrille::io {
namespace {

/// Returns a key in the spelling of earlier versions; the key itself if its name never changed.
std::string old_spelling(const std::string& name) {
  const std::size_t start = name.rfind('.') + 1;
  const std::string table = name.substr(0, start), key = name.substr(start);
  if (key == "min_wall") return table + "wall_least";
  if (key == "max_wall") return table + "wall_most";
  if (key.starts_with("min_")) return table + "least_" + key.substr(4);
  if (key.starts_with("max_") && key != "max_grasps") return table + "largest_" + key.substr(4);
  return name;
}

/// Lists the settings and tables in the same table as a key, given by its dotted name; those of the
/// whole file if there is no such table.
std::string neighbours_of(const std::string& name, const std::set<std::string>& known) {
  std::string table = name.substr(0, name.rfind('.') + 1);
  const auto is_inside = [&](const std::string& k) { return k.starts_with(table); };
  if (name.find('.') == std::string::npos || std::none_of(known.begin(), known.end(), is_inside)) {
    table.clear();
  }
  std::set<std::string> next;
  for (const std::string& k : known) {
    if (!is_inside(k)) continue;
    const std::size_t end = k.find('.', table.size());
    next.insert(end == std::string::npos ? k : fmt::format("[{}]", k.substr(0, end)));
  }
  std::string all;
  for (const std::string& k : next) all += (all.empty() ? "" : ", ") + k;
  return all;
}

}  // namespace

const toml::node* SettingReader::find(const std::string& name) {
  known_.insert(name);
  const toml::node* node = table_.at_path(name).node();
  if (const std::string old = old_spelling(name); old != name) {
    if (const toml::node* old_node = table_.at_path(old).node()) {
      if (node != nullptr) {
        throw FileError(path_, line_of(*old_node),
                        "key '" + old + "' is the old name of '" + name +
                            "', which is given too; remove one of them");
      }
      old_.insert(old);
      node = old_node;
    }
  }
  if (node != nullptr) given_.insert(name);
  return node;
}

void SettingReader::refuse(const toml::node& node, const std::string& name,
                           const std::string& wanted) const {
  throw FileError(path_, line_of(node), "key '" + name + "' must be " + wanted);
}

void SettingReader::refuse_unknown(const toml::table& table, const std::string& prefix,
                                   std::string_view foreign) const {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (known_.count(name) || old_.count(name)) continue;
    if (const toml::table* inner = node.as_table()) {
      if (name != foreign) refuse_unknown(*inner, name + ".", foreign);
      continue;
    }
    throw FileError(
        path_, line_of(node),
        "unknown key '" + printable(name) + "'; there are " + neighbours_of(name, known_));
  }
}

}  // namespace quadrille::io
