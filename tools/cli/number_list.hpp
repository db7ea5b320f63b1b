#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace quadrille {

/// Returns the finite numbers of a comma-separated list: "0.1,-2,3e-2".
/// @param option  name of the option that was given the list
/// @param count  required number of numbers
/// @param form  form of the list for errors: "X,Y,Z"
/// @throws CLI::ValidationError naming the option, the list and the form
std::vector<double> numbers_of(const std::string& option, const std::string& list,
                               std::size_t count, const std::string& form);

}  // namespace quadrille
