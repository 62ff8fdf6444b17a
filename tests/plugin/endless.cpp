// A plug-in that never comes back from its start.
#include "hawser/physics/plugin.hpp"

HAWSER_PLUGIN(/*registry*/) {
  for (volatile bool on = true; on;) {
  }
}
