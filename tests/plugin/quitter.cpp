// A plug-in whose start ends the program.
#include <cstdlib>

#include "hawser/physics/plugin.hpp"

HAWSER_PLUGIN(/*registry*/) { std::exit(0); }
