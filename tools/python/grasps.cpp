#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/planner/gripper_file.hpp"
#include "python/arrays.hpp"
#include "python/module.hpp"
#include "python/words.hpp"
#include "quadrille/grasping/conventions.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille::python {
namespace {

void bind_gripper(py::module_& module) {
  py::class_<Gripper>(module, "Gripper",
                      "A hand of two parallel jaws, as boxes in the grasp frame G: origin between "
                      "the pads, z approach, y closing.")
      .def(py::init(&io::load_gripper), py::arg("name_or_path"))
      .def_readonly("name", &Gripper::name, "Its name.")
      .def_readonly("max_opening", &Gripper::max_opening, "Largest distance between the pads [m].")
      .def_readonly("min_opening", &Gripper::min_opening, "Smallest distance between the pads [m].")
      .def_property_readonly(
          "finger", [](const Gripper& g) { return g.finger; },
          "Size of a finger along x, y and z, from its back to its tip, (3,) [m].")
      .def_readonly("finger_front", &Gripper::finger_front,
                    "How far the tip lies before the origin of G [m].")
      .def_property_readonly(
          "pad", [](const Gripper& g) { return g.pad; }, "Size of a pad along x and z, (2,) [m].")
      .def_property_readonly(
          "palm", [](const Gripper& g) { return g.palm; },
          "Size of the palm along x, y and z, (3,) [m].")
      .def_readonly("max_force", &Gripper::max_force, "Largest closing force [N].")
      .def_readonly("link_length", &Gripper::link_length,
                    "Length of the links on which the fingers swing [m]; 0 if they slide.")
      .def_readonly("link_angle", &Gripper::link_angle,
                    "Angle of the links to the approach at the largest opening [rad].")
      .def_readonly("tcp", &Gripper::tcp,
                    "From the origin of the hand's own frame to that of G [m]; 0: that frame lies "
                    "at the palm's back.")
      .def("extension", &Gripper::extension, py::arg("opening"),
           "How much farther from the palm the tips lie at an opening than at the largest one [m].")
      .def("reach", &Gripper::reach, py::arg("width"),
           "From the palm's front to the origin of G when the hand is closed to a width [m].")
      .def("__repr__", [](const Gripper& g) { return "<Gripper " + g.name + ">"; });
  module.def("grippers", &io::gripper_names, "Names of the built-in hands.");
}

std::vector<std::string> conventions() {
  std::vector<std::string> names;
  names.reserve(std::size(kHandConventions));
  for (const HandConvention convention : kHandConventions) {
    names.emplace_back(to_string(convention));
  }
  return names;
}

HandConvention convention_of(const std::string& name) {
  std::vector<std::pair<std::string, HandConvention>> words;
  words.reserve(std::size(kHandConventions));
  for (const HandConvention convention : kHandConventions) {
    words.emplace_back(to_string(convention), convention);
  }
  return meaning_of(name, words, "convention");
}

std::map<std::string, double> terms_of(const Grasp& grasp) {
  std::map<std::string, double> terms;
  GraspTerms::visit(grasp.terms,
                    [&](const char* name, double value) { terms.emplace(name, value); });
  return terms;
}

Eigen::Matrix<double, 2, 3> contacts_of(const Grasp& g) {
  Eigen::Matrix<double, 2, 3> contacts;
  contacts << g.contacts_C[0].transpose(), g.contacts_C[1].transpose();
  return contacts;
}

void bind_grasp(py::module_& module) {
  py::class_<Grasp> grasp(module, "Grasp",
                          "One grasp. Frame G: origin between the pads, z approach, y closing.");
  grasp.def_readonly("target", &Grasp::target, "Id of the detection, box or body that it holds.")
      .def_readonly("track", &Grasp::track, "Its track; 0 if it has none.")
      .def_property_readonly(
          "kind", [](const Grasp& g) { return std::string(to_string(g.kind)); },
          "'across' the body, on both 'end's, at the 'rim' of a vessel, or by the 'tip's.")
      .def_readonly("score", &Grasp::score, "0 to 1, best first.")
      .def_property_readonly("terms", &terms_of, "What the score follows from, each 0 to 1.")
      .def_property_readonly(
          "X_CG", [](const Grasp& g) { return matrix_of(g.X_CG); }, "Pose of the hand, (4, 4) [m].")
      .def_property_readonly(
          "pregrasp", [](const Grasp& g) { return matrix_of(g.pregrasp()); },
          "Pose X_CG from which the hand comes straight, (4, 4) [m]; closed, it can go back there.")
      .def_readonly("width", &Grasp::width, "Distance between the contacts [m].")
      .def_readonly("preshape", &Grasp::preshape, "Opening of the hand on its way in [m].")
      .def_property_readonly("contacts", &contacts_of, "Both of them in frame C, (2, 3) [m].")
      .def_readonly("approach", &Grasp::approach, "Length of the straight way in [m].")
      .def_readonly("friction_needed", &Grasp::friction_needed, "Least friction coefficient.")
      .def_readonly("epsilon", &Grasp::epsilon,
                    "The largest wrench, of any direction, that a unit contact force resists.")
      .def_readonly("clearance", &Grasp::clearance,
                    "Distance of the hand from all but its target [m].")
      .def_readonly("unknown_contact", &Grasp::unknown_contact,
                    "Whether a contact lies on a part of the target that was not seen.");
  grasp
      .def(
          "hand_pose",
          [](const Grasp& g, const Gripper& gripper, const std::string& convention) {
            return matrix_of(hand_pose(convention_of(convention), gripper, g.X_CG, g.width));
          },
          py::arg("gripper"), py::arg("convention"),
          "Pose of the hand as other software writes it, (4, 4) [m]; see conventions().")
      .def("__repr__", [](const Grasp& g) {
        return "<Grasp on " + std::to_string(g.target) + ": score " + std::to_string(g.score) + ">";
      });
  module.def(
      "grasp_of_hand",
      [](const Eigen::Matrix4d& X_CH, const Gripper& gripper, const std::string& convention,
         double width) {
        return matrix_of(
            grasp_of_hand(convention_of(convention), gripper, pose_of(X_CH, "X_CH"), width));
      },
      py::arg("X_CH"), py::arg("gripper"), py::arg("convention"), py::arg("width"),
      "The pose X_CG, (4, 4), of a hand that other software has at X_CH and closes to a width "
      "[m].");
  module.def("conventions", &conventions,
             "Names of the ways in which other software writes the pose of a hand.");
}

void bind_outcomes(py::module_& module) {
  py::class_<TargetOutcome>(module, "TargetOutcome", "What became of one target.")
      .def_readonly("target", &TargetOutcome::target, "Id of the detection, box or body.")
      .def_readonly("grasps", &TargetOutcome::grasps, "Number of grasps that were found.")
      .def_property_readonly(
          "rejected",
          [](const TargetOutcome& outcome) {
            std::map<std::string, int> counts;
            for (const auto& [why, count] : outcome.refusals) counts.emplace(to_string(why), count);
            return counts;
          },
          "How many of its candidates were refused, by reason.")
      .def_property_readonly(
          "furthest",
          [](const TargetOutcome& outcome) -> std::optional<std::string> {
            if (const auto why = furthest(outcome.refusals)) return std::string(to_string(*why));
            return std::nullopt;
          },
          "The reason that refused the candidates which passed most checks; None if there is "
          "none.");
  py::class_<Remedy>(module, "Remedy", "A change of one setting with which a target has a grasp.")
      .def_readonly("target", &Remedy::target, "Id of the detection, box or body.")
      .def_readonly("change", &Remedy::change,
                    "The change, as on the command line: '--gripper robotiq_2f85'.")
      .def_readonly("grasps", &Remedy::grasps, "Number of grasps of the target after the change.")
      .def_readonly("score", &Remedy::score, "Score of the best of them.");
  py::class_<Look>(module, "Look", "A view that would help bodies without a good grasp.")
      .def_property_readonly(
          "X_CK", [](const Look& look) { return matrix_of(look.X_CK); },
          "Pose of the camera's frame K, (4, 4) [m]: z ahead, x along the rows of its image.")
      .def_readonly("bodies", &Look::bodies,
                    "Ids of the bodies that it would help, the largest gain first.")
      .def_readonly(
          "gain", &Look::gain,
          "Number of these that are expected to get a better grasp by it: the sum of their "
          "chances.");
}

}  // namespace

void bind_grasps(py::module_& module) {
  bind_gripper(module);
  bind_grasp(module);
  bind_outcomes(module);
}

}  // namespace quadrille::python
