#include "src/row_layout.hpp"

#include <algorithm>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/fields/moved_position.hpp"

namespace hawser {
namespace {

/// Rows of one team of blocks that are governed, or to which modules add.
struct Candidate {
  std::string name;
  bool governed;
  long long rows = 0;             // on all ranks
  std::vector<char> has_field{};  // on all ranks
};

/// Per owned row: index of its candidate, [team][added, governed]; or RowLayout::follows.
int candidate_of(const Governance& governance, std::size_t row) {
  const int governor = governance.governor[row];
  if (governor == Governance::kinematic) return RowLayout::follows;
  return 2 * governance.team_of_row[row] + (governor == Governance::shared ? 0 : 1);
}

std::vector<Candidate> find_candidates(const DofMap& dofs, const Governance& governance) {
  std::vector<Candidate> result;
  for (std::size_t team = 0; team < governance.blocks.size(); ++team) {
    std::vector<std::string> members;
    for (std::size_t block = 0; block < governance.blocks.size(); ++block)
      if (governance.team_of_block[block] == static_cast<int>(team))
        members.push_back(governance.blocks[block]);
    for (const bool governed : {false, true})
      result.push_back({listed(members), governed});
  }
  for (Candidate& candidate : result)
    candidate.has_field.assign(dofs.fields().size(), 0);
  for (LocalIndex row = 0; row < dofs.owned(); ++row) {
    const int index = candidate_of(governance, static_cast<std::size_t>(row));
    if (index < 0) continue;
    Candidate& candidate = result[static_cast<std::size_t>(index)];
    ++candidate.rows;
    candidate.has_field[static_cast<std::size_t>(dofs.info(row).field)] = 1;
  }
  const Communicator& communicator = dofs.mesh().communicator;
  for (Candidate& candidate : result) {
    candidate.rows = communicator.sum(candidate.rows);
    for (char& has : candidate.has_field)
      has = communicator.any(has != 0) ? 1 : 0;
  }
  return result;
}

bool displaces(const DofMap& dofs, const Candidate& candidate) {
  for (std::size_t field = 0; field < dofs.fields().size(); ++field)
    if (candidate.has_field[field] != 0 &&
        !(dofs.fields()[field].places_nodes &&
          dofs.fields()[field].components == dofs.mesh().dimension))
      return false;
  return true;
}

/// The candidates that have rows, in the order to solve in.
std::vector<std::size_t> order(const std::vector<Candidate>& candidates) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i].rows > 0) result.push_back(i);
  std::stable_sort(result.begin(), result.end(), [&](std::size_t a, std::size_t b) {
    const Candidate &first = candidates[a], &second = candidates[b];
    if (first.governed != second.governed) return second.governed;
    return first.rows > second.rows;
  });
  const auto governed = [&](std::size_t i) { return candidates[i].governed; };
  if (!result.empty() && !governed(result.front()))
    std::rotate(result.begin() + 1, std::find_if(result.begin(), result.end(), governed),
                result.end());
  return result;
}

/// A second value of a field at a vertex, beyond a slit, has a node of its own.
bool at_one_node(const DofMap& dofs, LocalIndex row, LocalIndex next) {
  const RowInfo &a = dofs.info(row), &b = dofs.info(next);
  if (a.kind == b.kind) return a.point == b.point;
  return a.kind == PointKind::vertex && b.kind == PointKind::split_vertex &&
         dofs.mesh().vertex_of_split[static_cast<std::size_t>(b.point)] == a.point;
}

}  // namespace

RowLayout lay_out_rows(const DofMap& dofs, const Governance& governance) {
  RowLayout layout;
  layout.dimension = dofs.mesh().dimension;
  const std::vector<Candidate> candidates = find_candidates(dofs, governance);
  std::vector<int> group(candidates.size(), RowLayout::follows);
  for (const std::size_t i : order(candidates)) {
    group[i] = static_cast<int>(layout.groups.size());
    layout.groups.push_back({candidates[i].name, displaces(dofs, candidates[i])});
  }
  std::vector<int> first_kind;
  for (const FieldDescription& field : dofs.fields()) {
    first_kind.push_back(layout.kinds);
    layout.kinds += field.components;
  }
  LocalIndex node = 0;
  for (LocalIndex row = 0; row < dofs.owned(); ++row) {
    const int candidate = candidate_of(governance, static_cast<std::size_t>(row));
    layout.group.push_back(candidate < 0 ? candidate : group[static_cast<std::size_t>(candidate)]);
    if (row > 0 && !at_one_node(dofs, row - 1, row)) ++node;
    layout.node.push_back(node);
    const RowInfo& info = dofs.info(row);
    layout.kind.push_back(first_kind[static_cast<std::size_t>(info.field)] + info.component);
  }
  return layout;
}

void place_rows(const DofMap& dofs, const State& state, RowLayout& layout) {
  const MovedPosition moved(dofs, field_name::displacement);
  const auto dimension = static_cast<std::size_t>(layout.dimension);
  const std::size_t nodes =
      layout.node.empty() ? 0 : static_cast<std::size_t>(layout.node.back()) + 1;
  layout.positions.resize(nodes * dimension);
  for (std::size_t row = 0; row < layout.node.size(); ++row)
    if (row == 0 || layout.node[row] != layout.node[row - 1])
      moved.position(static_cast<LocalIndex>(row), state,
                     &layout.positions[static_cast<std::size_t>(layout.node[row]) * dimension]);
}

}  // namespace hawser
