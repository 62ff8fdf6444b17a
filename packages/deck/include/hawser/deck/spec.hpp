#pragma once
// One declaration per parameter: name, unit, default, rules, meaning and the struct member it
// fills. The parser, the checks, `hawser describe`, the resolved deck, the schema and the reference
// page all come from it:
//
//   struct Parameters {
//     Located<std::string> region;
//     double density = 1000;
//     Newton newton;
//     std::vector<Dirichlet> dirichlets;
//     static Spec<Parameters> spec() {
//       using P = Parameters;
//       return Spec<P>("ale-fluid", "Incompressible flow on a moving mesh.")
//           .attribute("region", &P::region, required(), "Region that the fluid fills.")
//           .attribute("density", &P::density, "kg/m^3", positive(), "Mass density.")
//           .child(&P::newton)                         // Newton::spec() knows tag and meaning
//           .children(&P::dirichlets, required());     // at least one
//     }
//   };
//   const Parameters p = Parameters::spec().read(node, diagnostics);
//
// An attribute that is not required() has as its default what a fresh struct holds.
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hawser/deck/deck.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/node_spec.hpp"
#include "hawser/deck/rules.hpp"
#include "hawser/deck/spec_reader.hpp"
#include "hawser/deck/value.hpp"

namespace hawser {

template <class P>
class Spec {
 public:
  Spec(std::string tag, std::string meaning) : tag_(std::move(tag)), meaning_(std::move(meaning)) {}

  /// A physical quantity, or a count that has a unit.
  template <class T, class Owner>
  Spec&& attribute(const std::string& name, T Owner::*member, const std::string& unit,
                   const Rules& rules, const std::string& meaning) &&;
  template <class T, class Owner>
  Spec&& attribute(const std::string& name, T Owner::*member, const char* unit,
                   const std::string& meaning) && {
    return std::move(*this).attribute(name, member, std::string(unit), Rules(), meaning);
  }

  /// A text, a name, a truth value, a count.
  template <class T, class Owner>
  Spec&& attribute(const std::string& name, T Owner::*member, const Rules& rules,
                   const std::string& meaning) && {
    static_assert(!IsQuantity<T>::value, "a quantity needs a unit; give \"1\" when it has none");
    return std::move(*this).attribute(name, member, std::string(), rules, meaning);
  }
  template <class T, class Owner>
  Spec&& attribute(const std::string& name, T Owner::*member, const std::string& meaning) && {
    return std::move(*this).attribute(name, member, Rules(), meaning);
  }

  /// One of a few words, each standing for a value (an enumerator).
  template <class T, class Owner>
  Spec&& choice(const std::string& name, T Owner::*member, const Rules& rules,
                std::vector<std::pair<std::string, T>> words, const std::string& meaning) &&;
  template <class T, class Owner>
  Spec&& choice(const std::string& name, T Owner::*member,
                std::vector<std::pair<std::string, T>> words, const std::string& meaning) && {
    return std::move(*this).choice(name, member, Rules(), std::move(words), meaning);
  }

  /// A child element that stands at most once (exactly once with required()). When it is absent the
  /// member keeps its defaults; a std::optional member stays empty.
  template <class Q, class Owner>
  Spec&& child(Q Owner::*member, const Rules& rules = {}) && {
    return std::move(*this).child(member, Q::spec(), rules);
  }
  template <class Q, class Owner>
  Spec&& child(std::optional<Q> Owner::*member, const Rules& rules = {}) && {
    return std::move(*this).child(member, Q::spec(), rules);
  }
  /// A child that may be repeated; with required() at least one.
  template <class Q, class Owner>
  Spec&& children(std::vector<Q> Owner::*member, const Rules& rules = {}) && {
    return std::move(*this).children(member, Q::spec(), rules);
  }

  // The same with an explicit spec, for one struct under several tags.
  template <class Q, class Owner>
  Spec&& child(Q Owner::*member, Spec<Q> spec, const Rules& rules = {}) &&;
  template <class Q, class Owner>
  Spec&& child(std::optional<Q> Owner::*member, Spec<Q> spec, const Rules& rules = {}) &&;
  template <class Q, class Owner>
  Spec&& children(std::vector<Q> Owner::*member, Spec<Q> spec, const Rules& rules = {}) &&;

  /// All children that are not declared otherwise, unread: a higher layer finds their specs by tag
  /// and reports unknown ones with is_known_child(). `kind` says what they are ("physics modules").
  template <class Owner>
  Spec&& any_children(std::vector<DeckNode> Owner::*member, const std::string& kind) &&;

  /// Where the formulas behind the parameters are written down, such as "doc/numerics.md".
  Spec&& source(const std::string& page) && {
    source_ = page;
    return std::move(*this);
  }

  /// The member receives the place of the element itself.
  template <class Owner>
  Spec&& location(Location Owner::*member) &&;

  /// A check across several values; made only when all of them could be read.
  using Check = std::function<void(const P&, const Location&, Diagnostics&)>;
  Spec&& check(Check check) && {
    checks_.push_back(std::move(check));
    return std::move(*this);
  }

  /// Reads and checks `node`. Faults go to `diagnostics`; a faulty value is left at its default.
  P read(const DeckNode& node, Diagnostics& diagnostics) const {
    P value;
    if (is_expected_tag(node, tag_, diagnostics)) read_into(node, value, diagnostics);
    return value;
  }
  void read_into(const DeckNode& node, P& value, Diagnostics& diagnostics) const;

  const std::string& tag() const { return tag_; }
  NodeSpec node_spec(const P& defaults = P()) const;

 private:
  struct Attribute {
    AttributeSpec spec;  // without the default
    Rules rules;
    std::function<std::string(const Reading&, P&)> read;
    std::function<std::string(const P&)> write;
  };
  struct Child {
    ChildRule rule;
    std::function<void(const DeckNode&, P&, Diagnostics&)> read;
    std::function<ChildSpec(const P&)> describe;
  };

  std::string tag_, meaning_, source_, open_kind_;
  std::vector<Attribute> attributes_;
  std::vector<Child> children_;
  std::function<void(const DeckNode&, P&)> take_open_child_;
  std::vector<std::function<void(const Location&, P&)>> take_location_;
  std::vector<Check> checks_;
};

}  // namespace hawser

#include "hawser/deck/spec_impl.hpp"
