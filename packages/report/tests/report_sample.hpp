#pragma once
// A small mesh with two modules of a name, and steps on it, for reports to look at.
#include <string>
#include <vector>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/field_table.hpp"
#include "hawser/report/reports.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {

/// Water of 4 by 2 squares and, through its middle, a cable from (0, 1) to (4, 1); every cell of a
/// module adds the same load at each of its nodes.
class ReportSample {
 public:
  explicit ReportSample(const Communicator& communicator = Communicator())
      : mesh(sample_mesh(communicator)) {
    modules.push_back(module_with("flow", load("water", CellShape::triangle, 1)));
    modules.push_back(module_with("cable", load("cable", CellShape::line, 10)));
    modules.push_back(module_with("cable", load("cable", CellShape::line, 100)));
    table = gather_fields(modules);
    dofs = std::make_unique<DofMap>(mesh, table.fields);
    assembler = std::make_unique<Assembler>(*dofs, modules);
    const auto rows = static_cast<std::size_t>(dofs->rows());
    for (std::vector<double>* values :
         {&state.value, &state.rate, &state.accepted, &state.rate_slope, &state.rate_partner})
      values->assign(rows, 0);
    reactions.assign(rows, 0);
  }

  ReportContext context() const { return {*assembler, modules, table.rate_rules, tracks}; }
  Step step(int number = 1, bool last = false) const {
    return {number, 0.5, last, 0.25, 3, 7, state, state, reactions};
  }
  /// Value of a field at the vertices, from their reference positions.
  template <class Function>
  void set(const std::string& field, Function&& value) {
    for (LocalIndex row = 0; row < dofs->rows(); ++row) {
      const RowInfo& info = dofs->info(row);
      if (dofs->fields()[static_cast<std::size_t>(info.field)].name != field) continue;
      double x[3] = {0, 0, 0};
      dofs->position(row, x);
      state.value[static_cast<std::size_t>(row)] = value(x, info.component);
    }
  }
  /// Reads reports from an element <hawser>; made, and started in this folder.
  Reports reports(const ReportRegistry& registry, const std::string& text,
                  Diagnostics& faults) const {
    NodeSpec parent;
    parent.tag = "hawser";
    const Deck deck = parse_deck("<hawser>" + text + "</hawser>", "d.xml", faults);
    return Reports(registry.read(deck.root.children, parent, faults), context(), faults);
  }

  Mesh mesh;
  std::vector<PhysicsModule> modules;
  FieldTable table;
  Tracks tracks;
  std::unique_ptr<DofMap> dofs;
  std::unique_ptr<Assembler> assembler;
  State state;
  std::vector<double> reactions;

 private:
  static Mesh sample_mesh(const Communicator& communicator) {
    MeshText text = grid(4, 2);
    text.groups.push_back(line("cable", {5, 6, 7, 8, 9}));
    text.groups.push_back({"tow-point", 0, {{5}}});
    text.groups.push_back({"tail", 0, {{9}}});
    return read_text(communicator, text.in_format("4.1"));
  }
  static std::unique_ptr<Kernel> load(const std::string& region, CellShape shape, double load) {
    return std::make_unique<LoadKernel>(
        region, shape, std::vector<FieldUse>{velocity(Role::adds), displacement(Role::adds)}, load);
  }
};

}  // namespace hawser
