#pragma once
// From a deck's tag to a physics module: its parameters' declaration and its maker. A plain object,
// filled by the built-in modules and by plug-ins in the same way.
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "hawser/deck/spec.hpp"
#include "hawser/physics/kernel.hpp"

namespace hawser {

/// What a module is made for, beside its parameters: known before the mesh is read.
struct ModuleContext {
  int dimension = 2;  ///< of the mesh
};

class ModuleRegistry {
 public:
  struct Entry {
    NodeSpec spec;
    std::function<PhysicsModule(const DeckNode&, const ModuleContext&, Diagnostics&)> make;
  };

  /// Parameters has a static spec(), whose tag names the module in decks. `make` builds the module
  /// from (parameters), from (parameters, context), or, where a parameter can be wrong for the
  /// mesh's dimension, from (parameters, context, diagnostics).
  template <class Parameters, class Make>
  void add(Make make) {
    const Spec<Parameters> spec = Parameters::spec();
    insert(spec.tag(),
           {spec.node_spec(), [spec, make](const DeckNode& node, const ModuleContext& context,
                                           Diagnostics& diagnostics) {
              const std::size_t before = diagnostics.error_count();
              const Parameters parameters = spec.read(node, diagnostics);
              if (diagnostics.error_count() != before) return PhysicsModule();
              if constexpr (std::is_invocable_v<Make, const Parameters&>)
                return make(parameters);
              else if constexpr (std::is_invocable_v<Make, const Parameters&, const ModuleContext&>)
                return make(parameters, context);
              else
                return make(parameters, context, diagnostics);
            }});
  }

  const Entry* find(const std::string& tag) const;  ///< null when there is none
  std::vector<std::string> tags() const;            ///< sorted

 private:
  void insert(const std::string& tag, Entry entry);  ///< PluginError when the tag is taken
  std::map<std::string, Entry> entries_;
};

}  // namespace hawser
