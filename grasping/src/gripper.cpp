#include "quadrille/grasping/gripper.hpp"
