// A plug-in of another build: refused by its stamp, before anything else of it is called.
#include <cstdlib>

#include "hawser/physics/module_registry.hpp"

extern "C" const char* hawser_plugin_stamp() { return "hawser-abi-0/gcc-4.0.0"; }
extern "C" void hawser_plugin_register(hawser::ModuleRegistry& /*registry*/) { std::abort(); }
