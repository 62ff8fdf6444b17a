// A plug-in of this build that lacks a library of its own.
#include "hawser/physics/plugin.hpp"

extern void of_a_library_that_is_not_linked();
HAWSER_PLUGIN(/*registry*/) { of_a_library_that_is_not_linked(); }
