#include "group_rows.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>

#include "sub_matrix.hpp"

namespace hawser {
namespace {

constexpr long long few_rows = 300000;   // of a group that MUMPS factors as fast
constexpr long long fewest_rows = 3000;  // of multigrid, which is to have a coarser level
constexpr double most_idle_places = .1;  // per unknown

bool is_prescribed(const RowLayout& layout, std::size_t row) {
  return !layout.prescribed.empty() && layout.prescribed[row] != 0;
}

double diagonal(const TpetraMatrix& matrix, LocalIndex row) {
  const auto local = matrix.getLocalMatrixHost();  // columns: the rows, then the ghosts
  for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k)
    if (local.graph.entries(k) == row) return local.values(k);
  return 0;
}

/// Gives every node of the group a place for each kind of unknown that the group has.
void pad(const BlockSystem& system, GroupRows& group) {
  const RowLayout& layout = system.layout;
  group.dimension = layout.dimension;
  std::vector<LocalIndex> place_of_kind(static_cast<std::size_t>(layout.kinds),
                                        SubMatrix::identity);
  for (const LocalIndex row : group.rows)
    place_of_kind[static_cast<std::size_t>(layout.kind[static_cast<std::size_t>(row)])] = 0;
  for (LocalIndex& place : place_of_kind)
    if (system.communicator.any(place == 0)) place = group.per_node++;
  std::vector<LocalIndex> places, columns;
  LocalIndex node = -1;
  for (const LocalIndex row : group.rows) {
    const auto r = static_cast<std::size_t>(row);
    if (layout.node[r] != node) {
      node = layout.node[r];
      places.insert(places.end(), static_cast<std::size_t>(group.per_node), SubMatrix::identity);
      columns.resize(places.size(), SubMatrix::identity);
      const double* const x = &layout.positions[static_cast<std::size_t>(node * layout.dimension)];
      group.positions.insert(group.positions.end(), x, x + layout.dimension);
    }
    const LocalIndex place = place_of_kind[static_cast<std::size_t>(layout.kind[r])];
    const std::size_t here = places.size() - static_cast<std::size_t>(group.per_node - place);
    const bool known = is_prescribed(layout, r);
    if (!known) places[here] = row;
    if (!known || !group.displaces) columns[here] = row;
  }
  group.rows = std::move(places);
  group.columns = std::move(columns);
}

/// Why multigrid cannot solve for these rows.
std::string objection(const BlockSystem& system, const TpetraMatrix& matrix,
                      const GroupRows& padded, long long rows) {
  const Communicator& communicator = system.communicator;
  if (rows < fewest_rows) return "it is small";
  const auto places = communicator.sum(static_cast<long long>(padded.rows.size()));
  if (static_cast<double>(places - rows) > most_idle_places * static_cast<double>(rows))
    return "its nodes have different unknowns";
  bool zero = false;
  for (const LocalIndex row : padded.rows)
    zero = zero || (row != SubMatrix::identity && diagonal(matrix, row) == 0);
  return communicator.any(zero) ? "a diagonal entry is zero" : "";
}

}  // namespace

GroupRows group_rows(const BlockSystem& system, const TpetraMatrix& matrix, int group,
                     LinearOptions::BlockMethod method) {
  using Method = LinearOptions::BlockMethod;
  const RowLayout& layout = system.layout;
  GroupRows result;
  const auto owned = static_cast<LocalIndex>(matrix.getNodeNumRows());
  for (LocalIndex row = 0; row < owned; ++row)
    if (group == GroupRows::everything || layout.group[static_cast<std::size_t>(row)] == group)
      result.rows.push_back(row);
  if (group == GroupRows::everything) {
    result.name = "everything";
    result.as_they_are = true;
    result.columns = result.rows;
    return result;
  }
  result.name = layout.groups[static_cast<std::size_t>(group)].name;
  result.displaces = layout.groups[static_cast<std::size_t>(group)].displaces;
  const auto rows = system.communicator.sum(static_cast<long long>(result.rows.size()));
  if (method == Method::multigrid || (method == Method::automatic && rows > few_rows)) {
    GroupRows padded = result;
    pad(system, padded);
    result.objection = objection(system, matrix, padded, rows);
    if (result.objection.empty()) return padded;
  }
  result.rows.erase(std::remove_if(result.rows.begin(), result.rows.end(),
                                   [&](LocalIndex row) {
                                     return is_prescribed(layout, static_cast<std::size_t>(row));
                                   }),
                    result.rows.end());
  result.columns = result.rows;
  return result;
}

std::vector<GlobalIndex> group_columns(const BlockSystem& system, const TpetraMatrix& matrix,
                                       const GroupRows& group, const TpetraMap& map) {
  const RowLayout& layout = system.layout;
  std::vector<GlobalIndex> numbers(matrix.getNodeNumRows(), SubMatrix::absent);
  for (std::size_t i = 0; i < group.columns.size(); ++i)
    if (group.columns[i] != SubMatrix::identity)
      numbers[static_cast<std::size_t>(group.columns[i])] =
          map.getGlobalElement(static_cast<LocalIndex>(i));
  std::vector<GlobalIndex> columns = spread(matrix, numbers);
  if (group.as_they_are) return columns;
  const std::vector<GlobalIndex> known =
      spread(matrix, std::vector<GlobalIndex>(layout.prescribed.begin(), layout.prescribed.end()));
  for (const Follower& follower : layout.followers)
    if (known[static_cast<std::size_t>(follower.row)] == 0)
      columns[static_cast<std::size_t>(follower.row)] =
          columns[static_cast<std::size_t>(follower.leader)];
  return columns;
}

std::vector<char> leaders_nodes(const BlockSystem& system, const GroupRows& group) {
  const RowLayout& layout = system.layout;
  std::vector<char> leads(
      layout.node.empty() ? 0 : static_cast<std::size_t>(layout.node.back()) + 1, 0);
  for (const Follower& follower : layout.followers)
    if (static_cast<std::size_t>(follower.leader) < layout.node.size())
      leads[static_cast<std::size_t>(layout.node[static_cast<std::size_t>(follower.leader)])] = 1;
  std::vector<char> result;
  for (const LocalIndex row : group.rows)
    result.push_back(
        row != SubMatrix::identity && !group.as_they_are
            ? leads[static_cast<std::size_t>(layout.node[static_cast<std::size_t>(row)])]
            : 0);
  return result;
}

}  // namespace hawser
