#include "io/planner/gripper_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <stdexcept>
#include <utility>

#include "io/planner/gripper_files.hpp"
#include "io/toml_file.hpp"

namespace quadrille::io {
namespace {

/// Reads one key after the other and remembers which ones it knows.
class GripperReader {
 public:
  GripperReader(const std::string& path, toml::table table)
      : path_(path), table_(std::move(table)) {}

  void read(const char* key, double* value) { *value = number(key, required(key)); }

  /// Leaves the value alone where the key is missing.
  void read_if_there(const char* key, double* value) {
    known_.insert(key);
    if (const toml::node* node = table_.get(key)) *value = number(key, *node);
  }

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
    return table_["name"].value_or(std::filesystem::path(path_).stem().string());
  }

  void refuse_unknown() const {
    for (const auto& [key, node] : table_) {
      if (!known_.count(std::string(key.str()))) {
        throw FileError(
            path_, line_of(node),
            "unknown key '" + std::string(key.str()) + "'; remove it or mend its spelling");
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

Gripper gripper_from(toml::table table, const std::string& path) {
  GripperReader reader(path, std::move(table));
  Gripper gripper;
  gripper.name = reader.read_name();
  reader.read("max_opening", &gripper.max_opening);
  reader.read("min_opening", &gripper.min_opening);
  reader.read("finger", &gripper.finger);
  reader.read("finger_front", &gripper.finger_front);
  reader.read("pad", &gripper.pad);
  reader.read("palm", &gripper.palm);
  reader.read("max_force", &gripper.max_force);
  reader.read_if_there("link_length", &gripper.link_length);
  reader.read_if_there("link_angle", &gripper.link_angle);
  reader.read_if_there("tcp", &gripper.tcp);
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

std::vector<std::string> gripper_names() {
  std::vector<std::string> names;
  for (const GripperText& file : gripper_texts()) names.push_back(file.name);
  return names;
}

std::string gripper_toml(const std::string& name) {
  for (const GripperText& file : gripper_texts()) {
    if (file.name == name) return file.toml;
  }
  throw std::invalid_argument(
      fmt::format("unknown gripper '{}'; known: {}", name, fmt::join(gripper_names(), ", ")));
}

}  // namespace quadrille::io
