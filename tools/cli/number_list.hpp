#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace quadrille {

/// The finite numbers of a list that commas separate: "0.1,-2,3e-2".
/// @param option  that the list was given to
/// @param count   of numbers that it must hold
/// @param form    what they are: "X,Y,Z"
/// @throws CLI::ValidationError that names the option, the list and the form
std::vector<double> numbers_of(const std::string& option, const std::string& list,
                               std::size_t count, const std::string& form);

}  // namespace quadrille
