#pragma once
// From a deck's tag to a physics module: its parameters' declaration and its maker. A plain object,
// filled by the built-in modules and by plug-ins in the same way.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hawser/deck/spec.hpp"
#include "hawser/physics/kernel.hpp"

namespace hawser {

class ModuleRegistry {
 public:
  struct Entry {
    NodeSpec spec;
    std::function<PhysicsModule(const DeckNode&, Diagnostics&)> make;
  };

  /// Parameters has a static spec(), whose tag names the module in decks; `make` builds it from
  /// them.
  template <class Parameters>
  void add(std::function<PhysicsModule(const Parameters&)> make) {
    const Spec<Parameters> spec = Parameters::spec();
    insert(spec.tag(),
           {spec.node_spec(), [spec, make](const DeckNode& node, Diagnostics& diagnostics) {
              const std::size_t before = diagnostics.error_count();
              const Parameters parameters = spec.read(node, diagnostics);
              return diagnostics.error_count() == before ? make(parameters) : PhysicsModule();
            }});
  }

  const Entry* find(const std::string& tag) const;  ///< null when there is none
  std::vector<std::string> tags() const;            ///< sorted

 private:
  void insert(const std::string& tag, Entry entry);  ///< PluginError when the tag is taken
  std::map<std::string, Entry> entries_;
};

}  // namespace hawser
