#include "io/planner/gripper_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "io/planner/gripper_files.hpp"
#include "io/settings/setting_text.hpp"
#include "io/settings/toml_file.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::io {
namespace {

/// Reads one key after the other and remembers which keys are known.
class GripperReader {
 public:
  GripperReader(const std::string& path, toml::table table)
      : path_(path), table_(std::move(table)) {}

  void read(const char* key, double* value) { *value = number(key, required(key)); }

  /// Returns whether an optional key is given.
  bool has(const char* key) const { return table_.contains(key); }

  template <int Size>
  void read(const char* key, Eigen::Matrix<double, Size, 1>* value) {
    const toml::node& node = required(key);
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != Size) {
      throw FileError(path_, line_of(node),
                      "key '" + std::string(key) + "' must be an array of " + std::to_string(Size) +
                          " numbers [m]");
    }
    for (int i = 0; i < Size; ++i) (*value)[i] = number(key, (*array)[static_cast<size_t>(i)]);
  }

  std::string read_name() {
    known_.insert("name");
    const std::string name =
        table_["name"].value_or(printable(std::filesystem::path(path_).stem().string()));
    if (name != printable(name) || name.find_first_of("\"\\") != name.npos) {
      throw FileError(path_, "", "key 'name' must be text of at most 80 bytes without quotes");
    }
    return name;
  }

  void refuse_unknown() const {
    for (const auto& [key, node] : table_) {
      if (!known_.count(std::string(key.str()))) {
        throw FileError(
            path_, line_of(node),
            "unknown key '" + printable(key.str()) + "'; remove it or mend its spelling");
      }
    }
  }

 private:
  const toml::node& required(const char* key) {
    known_.insert(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) throw FileError(path_, "", "key '" + std::string(key) + "' is missing");
    return *node;
  }

  double number(const char* key, const toml::node& node) const {
    if (!node.is_number()) {
      throw FileError(path_, line_of(node), "key '" + std::string(key) + "' must be a number");
    }
    return *node.value<double>();
  }

  const std::string& path_;
  toml::table table_;
  std::set<std::string> known_;
};

/// Visits each field of a gripper except its name, with its key and whether the file must have it.
template <class SomeGripper, class Visit>
void visit_fields(SomeGripper& gripper, const Visit& visit) {
  visit("max_opening", gripper.max_opening, true);
  visit("min_opening", gripper.min_opening, true);
  visit("finger", gripper.finger, true);
  visit("finger_front", gripper.finger_front, true);
  visit("pad", gripper.pad, true);
  visit("palm", gripper.palm, true);
  visit("max_force", gripper.max_force, true);
  visit("link_length", gripper.link_length, false);
  visit("link_angle", gripper.link_angle, false);
  visit("tcp", gripper.tcp, false);
}

Gripper gripper_from(toml::table table, const std::string& path) {
  GripperReader reader(path, std::move(table));
  Gripper gripper;
  gripper.name = reader.read_name();
  visit_fields(gripper, [&](const char* key, auto& field, bool required) {
    if (required || reader.has(key)) reader.read(key, &field);
  });
  reader.refuse_unknown();
  try {
    gripper.check();
  } catch (const std::invalid_argument& error) {
    throw FileError(path, "", error.what());
  }
  return gripper;
}

}  // namespace

Gripper read_gripper(const std::string& path) { return gripper_from(read_toml(path), path); }

Gripper load_gripper(const std::string& name_or_path) {
  if (name_or_path.ends_with(".toml")) return read_gripper(name_or_path);
  const std::string path = name_or_path + ".toml";
  return gripper_from(parse_toml(gripper_toml(name_or_path), path), path);
}

std::string to_toml(const Gripper& gripper) {
  std::string text = fmt::format("name = \"{}\"\n", gripper.name);
  visit_fields(gripper, [&](const char* key, const auto& field, bool) {
    if constexpr (std::is_same_v<decltype(field), const double&>) {
      text += fmt::format("{} = {}\n", key, toml_of(field));
    } else {
      const std::vector<double> numbers(field.begin(), field.end());
      text += fmt::format("{} = {}\n", key, toml_of(numbers));
    }
  });
  return text;
}

std::vector<std::string> gripper_names() {
  std::vector<std::string> names;
  for (const GripperText& file : gripper_texts()) names.push_back(file.name);
  return names;
}

std::string gripper_toml(const std::string& name) {
  for (const GripperText& file : gripper_texts()) {
    if (file.name == name) return file.toml;
  }
  throw std::invalid_argument(fmt::format("unknown gripper '{}'; known: {}", printable(name),
                                          fmt::join(gripper_names(), ", ")));
}

}  // namespace quadrille::io
