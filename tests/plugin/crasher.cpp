// A plug-in whose start crashes.
#include <csignal>

#include "hawser/physics/plugin.hpp"

HAWSER_PLUGIN(/*registry*/) { std::raise(SIGSEGV); }
