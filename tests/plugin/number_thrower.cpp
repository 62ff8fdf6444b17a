// A plug-in whose start fails in an odd way.
#include "hawser/physics/plugin.hpp"

HAWSER_PLUGIN(/*registry*/) { throw 42; }
