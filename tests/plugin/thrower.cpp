// A plug-in whose start fails.
#include <stdexcept>

#include "hawser/physics/plugin.hpp"

HAWSER_PLUGIN(/*registry*/) { throw std::runtime_error("no licence server"); }
