// A plug-in whose library never ends being loaded.
#include "hawser/physics/plugin.hpp"

namespace {
struct Waiting {
  Waiting() {
    for (volatile bool on = true; on;) {
    }
  }
};
const Waiting waiting;
}  // namespace

HAWSER_PLUGIN(/*registry*/) {}
