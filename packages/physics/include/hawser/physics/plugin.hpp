#pragma once
// What a plug-in exports: a stamp, compared before anything else of it is called, and one function
// that fills the registry.
//
//   HAWSER_PLUGIN(registry) { registry.add<Heat::Parameters>(make_heat); }
#include "hawser/physics/abi.hpp"
#include "hawser/physics/module_registry.hpp"

#define HAWSER_PLUGIN(registry)                                                         \
  extern "C" __attribute__((visibility("default"))) const char* hawser_plugin_stamp() { \
    return HAWSER_ABI_STAMP;                                                            \
  }                                                                                     \
  extern "C" __attribute__((visibility("default"))) void hawser_plugin_register(        \
      ::hawser::ModuleRegistry& registry)
