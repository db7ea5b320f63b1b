#pragma once

#include "surfaces/evidence/confidence_model.hpp"

namespace quadrille {

// In the form that tools/lab/confidence/train_confidence.py prints. These weights were fitted to
// the truth of 461 scenes and to the probabilities of a larger model that had seen 1150 other
// scenes.

inline constexpr auto kTermRanges = std::to_array<TermRange>({
    {3.46574, 8.56203},      // log_count
    {0.0175716, 1.67723},    // spread
    {0, 0.879747},           // smooth_border
    {0, 0.980392},           // open_border
    {0, 0.995255},           // depth_edge
    {0, 0.911149},           // interior
    {-4.99914, -0.28012},    // log_size
    {-4.39091, -1.05185},    // log_cell
    {-2.00706, 6.74433},     // two_planes
    {-0.0174196, 7.76908},   // one_plane
    {-9.21034, -5.05931},    // log_sigma
    {0, 0.93675},            // common_noise
    {-1.30952, 1.75},        // log_residual
    {-1.63961, 1.37307},     // log_roughness
    {-0.0977732, 0.888336},  // correlation
    {-2.75618, 3.84965},     // convexity
    {-2.99573, 0.162506},    // log_in_front
    {-2.99573, 0.621146},    // log_behind
    {0.000142576, 1},        // uprightness
    {3, 9},                  // dof
    {-2, 0},                 // log_prior
});

inline constexpr auto kCurvedModel = std::to_array<ConfidenceWeight>({
    {-32.59514},
    {"log_count", 5.652353},
    {"spread", -1.783917},
    {"smooth_border", -18.27936},
    {"open_border", 1.761148},
    {"depth_edge", 10.95618},
    {"interior", -1.367185},
    {"log_size", -3.154208},
    {"log_cell", -0.7729733},
    {"two_planes", -0.4177845},
    {"one_plane", 2.63542},
    {"log_sigma", 0.5147086},
    {"common_noise", -0.2702124},
    {"log_residual", -0.6737485},
    {"log_roughness", 0.3960542},
    {"correlation", -6.399039},
    {"convexity", -4.053758},
    {"log_in_front", -2.10433},
    {"log_behind", -1.410321},
    {"uprightness", -4.538981},
    {"dof", 2.371975},
    {"log_prior", -0.9454063},
    {"log_count", "depth_edge", -4.343318},
    {"log_count", "log_residual", -1.178317},
    {"log_count", "correlation", -4.110262},
    {"spread", "smooth_border", -4.428034},
    {"spread", "log_size", 2.722637},
    {"spread", "log_cell", 0.2082726},
    {"spread", "log_sigma", -2.295414},
    {"spread", "common_noise", -1.115343},
    {"spread", "log_residual", 3.692679},
    {"spread", "log_roughness", -4.187393},
    {"spread", "convexity", 0.2716409},
    {"spread", "dof", -0.7389948},
    {"smooth_border", "open_border", 15.16119},
    {"smooth_border", "interior", 9.776301},
    {"smooth_border", "log_size", 4.317924},
    {"smooth_border", "log_sigma", -2.589934},
    {"smooth_border", "log_roughness", -3.90167},
    {"smooth_border", "log_behind", -0.8754914},
    {"depth_edge", "depth_edge", -7.923439},
    {"depth_edge", "log_cell", -7.880711},
    {"interior", "interior", 2.417277},
    {"interior", "common_noise", 8.596012},
    {"interior", "log_residual", 1.753561},
    {"interior", "convexity", 1.634833},
    {"interior", "log_behind", 1.297292},
    {"log_size", "log_roughness", -1.159715},
    {"log_size", "correlation", -2.929174},
    {"log_size", "dof", 0.5544631},
    {"log_cell", "log_cell", -1.434586},
    {"log_cell", "log_sigma", -0.496267},
    {"log_cell", "log_residual", -1.319183},
    {"log_cell", "correlation", -7.417629},
    {"two_planes", "two_planes", -0.5607539},
    {"two_planes", "one_plane", 1.110824},
    {"two_planes", "common_noise", 0.494929},
    {"two_planes", "correlation", -0.7425357},
    {"two_planes", "dof", -0.2588475},
    {"two_planes", "log_prior", -0.4346036},
    {"one_plane", "one_plane", -0.5977187},
    {"log_sigma", "convexity", -0.2847621},
    {"log_sigma", "log_behind", -0.1743504},
    {"common_noise", "common_noise", -3.988595},
    {"common_noise", "convexity", 0.9239778},
    {"log_residual", "log_residual", 0.7826132},
    {"log_residual", "correlation", -1.724759},
    {"log_residual", "convexity", -0.1324121},
    {"log_residual", "log_in_front", 0.4964547},
    {"log_residual", "log_prior", -0.4801814},
    {"log_roughness", "log_roughness", -1.151489},
    {"correlation", "correlation", 1.462981},
    {"correlation", "convexity", -1.550983},
    {"convexity", "convexity", -0.3400966},
    {"convexity", "log_behind", -0.4045512},
    {"convexity", "uprightness", -0.8969482},
    {"convexity", "dof", 0.3626729},
    {"convexity", "log_prior", 0.6616826},
    {"log_in_front", "log_in_front", -0.3659352},
    {"log_behind", "log_prior", 0.1402182},
    {"uprightness", "uprightness", 5.48467},
    {"log_prior", "log_prior", -1.156957},
});

inline constexpr auto kFlatModel = std::to_array<ConfidenceWeight>({
    {-2.741255},
    {"log_count", 1.425101},
    {"smooth_border", -4.719171},
    {"open_border", -5.534113},
    {"depth_edge", -5.289144},
    {"interior", -19.88872},
    {"log_size", 0.6494605},
    {"log_cell", 1.139958},
    {"two_planes", 0.1375933},
    {"log_sigma", -1.761598},
    {"log_residual", -3.094844},
    {"log_roughness", 1.055204},
    {"correlation", -0.1559072},
    {"log_in_front", 0.3744589},
    {"log_behind", 0.9713328},
    {"uprightness", -12.76076},
    {"smooth_border", "log_in_front", 1.579656},
    {"smooth_border", "log_behind", -1.473054},
    {"open_border", "depth_edge", 5.257493},
    {"open_border", "interior", 11.97064},
    {"interior", "interior", 11.83083},
    {"interior", "log_in_front", -2.459877},
    {"log_residual", "log_residual", 1.440759},
    {"log_residual", "log_roughness", -1.332596},
    {"log_residual", "correlation", -1.832326},
    {"uprightness", "uprightness", 11.94001},
});

}  // namespace quadrille
