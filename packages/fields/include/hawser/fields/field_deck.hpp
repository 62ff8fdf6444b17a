#pragma once
// <field>: what a run decides about a field, over its modules' wishes.
#include <optional>
#include <string>

#include "hawser/deck/spec.hpp"
#include "hawser/element/basis.hpp"

namespace hawser {

struct FieldDeck {
  Located<std::string> name;
  std::optional<Basis> basis;
  std::optional<Numbering> numbering;
  static Spec<FieldDeck> spec();
};

}  // namespace hawser
