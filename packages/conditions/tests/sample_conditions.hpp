#pragma once
// A small mesh with a fluid, a moving mesh and a structure, and conditions on it.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/assembler.hpp"
#include "hawser/assembly/field_table.hpp"
#include "hawser/conditions/conditions.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {

inline ConditionsDeck conditions_of(const std::string& text, Diagnostics& diagnostics) {
  const Deck deck = parse_deck("<conditions>" + text + "</conditions>", "d.xml", diagnostics);
  return ConditionsDeck::spec().read(deck.root, diagnostics);
}

/// Water of 4 by 2 squares and, through its middle, a cable from (0, 1) to (4, 1).
class SampleConditions {
 public:
  explicit SampleConditions(const std::string& text, const NamedSources& named = {}) {
    const ConditionsDeck deck = conditions_of(text, diagnostics);
    conditions =
        std::make_unique<Conditions>(assembler, table.rate_rules, deck, named, diagnostics);
    const auto rows = static_cast<std::size_t>(dofs.rows());
    for (std::vector<double>* values :
         {&state.value, &state.rate, &state.accepted, &state.rate_slope, &state.rate_partner})
      values->assign(rows, 0);
  }

  /// The prescribed row that stands for a field's component at the vertex (x, y); null if there is
  /// none. The last one holds.
  const PrescribedRow* find(const std::vector<PrescribedRow>& rows, const std::string& field,
                            int component, double x, double y) const {
    const PrescribedRow* found = nullptr;
    for (const PrescribedRow& candidate : rows) {
      const RowInfo& info = dofs.info(candidate.row);
      double X[3];
      dofs.position(candidate.row, X);
      if (info.field == dofs.find(field) && info.component == component && X[0] == x && X[1] == y)
        found = &candidate;
    }
    return found;
  }
  std::size_t row(const std::string& field, int component, double x, double y) const {
    for (LocalIndex candidate = 0; candidate < dofs.rows(); ++candidate) {
      const RowInfo& info = dofs.info(candidate);
      double X[3];
      dofs.position(candidate, X);
      if (info.field == dofs.find(field) && info.component == component && X[0] == x && X[1] == y)
        return static_cast<std::size_t>(candidate);
    }
    throw std::logic_error("no such row");
  }
  std::vector<PrescribedRow> prescribed_at(double time, double step = 1) {
    state.time = time;
    state.step = step;
    return conditions->prescribed(state, state);
  }

  Mesh mesh = sample_mesh();
  std::vector<PhysicsModule> modules = sample_modules();
  FieldTable table = gather_fields(modules);
  DofMap dofs{mesh, table.fields};
  Assembler assembler{dofs, modules};
  Diagnostics diagnostics;
  std::unique_ptr<Conditions> conditions;
  State state;

 private:
  static Mesh sample_mesh() {
    MeshText text = grid(4, 2);
    text.groups.push_back(line("cable", {5, 6, 7, 8, 9}));
    text.groups.push_back({"tail", 0, {{9}}});
    return read_text(Communicator(), text.in_format("4.1"));
  }
  static std::vector<PhysicsModule> sample_modules() {
    std::vector<PhysicsModule> modules;
    const auto add = [&](const char* name, const char* region, CellShape shape, Role moves) {
      modules.push_back(module_with(
          name,
          std::make_unique<LoadKernel>(
              region, shape, std::vector<FieldUse>{velocity(Role::adds), displacement(moves)}, 0)));
    };
    add("flow", "water", CellShape::triangle, Role::governs);
    add("cable", "cable", CellShape::line, Role::kinematic);
    return modules;
  }
};

}  // namespace hawser
