#include "hawser/physics/module_registry.hpp"

#include "hawser/base/error.hpp"

namespace hawser {

const ModuleRegistry::Entry* ModuleRegistry::find(const std::string& tag) const {
  const auto found = entries_.find(tag);
  return found == entries_.end() ? nullptr : &found->second;
}

std::vector<std::string> ModuleRegistry::tags() const {
  std::vector<std::string> tags;
  for (const auto& entry : entries_)
    tags.push_back(entry.first);
  return tags;
}

void ModuleRegistry::insert(const std::string& tag, Entry entry) {
  if (!entries_.emplace(tag, std::move(entry)).second)
    throw PluginError("two modules want the tag <" + tag + ">; rename one of them");
}

}  // namespace hawser
