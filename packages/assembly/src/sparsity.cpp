#include "src/sparsity.hpp"

#include <algorithm>

namespace hawser {

int Sparsity::find(LocalIndex row, LocalIndex column) const {
  const auto begin =
      columns.begin() + static_cast<std::ptrdiff_t>(row_begin[static_cast<std::size_t>(row)]);
  const auto end =
      columns.begin() + static_cast<std::ptrdiff_t>(row_begin[static_cast<std::size_t>(row) + 1]);
  const auto found = std::lower_bound(begin, end, column);
  return found == end || *found != column ? -1 : static_cast<int>(found - columns.begin());
}

Sparsity find_sparsity(LocalIndex owned_rows, const std::vector<KernelCells>& kernels,
                       const std::vector<std::pair<LocalIndex, LocalIndex>>& extra) {
  std::vector<std::vector<LocalIndex>> rows(static_cast<std::size_t>(owned_rows));
  for (LocalIndex row = 0; row < owned_rows; ++row)
    rows[static_cast<std::size_t>(row)].push_back(row);
  for (const auto& [row, column] : extra)
    if (row < owned_rows) rows[static_cast<std::size_t>(row)].push_back(column);
  for (const KernelCells& cells : kernels) {
    const auto n = static_cast<std::size_t>(cells.unknowns());
    for (std::size_t begin = 0; begin < cells.rows.size(); begin += n)
      for (std::size_t i = 0; i < n; ++i) {
        if (cells.writes[begin + i] == 0) continue;
        auto& row = rows[static_cast<std::size_t>(cells.rows[begin + i])];
        for (std::size_t j = 0; j < n; ++j)
          if (cells.rows[begin + j] >= 0) row.push_back(cells.rows[begin + j]);
      }
  }
  Sparsity result;
  result.row_begin.push_back(0);
  for (auto& row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    result.columns.insert(result.columns.end(), row.begin(), row.end());
    result.row_begin.push_back(result.columns.size());
  }
  return result;
}

void find_positions(const Sparsity& sparsity, KernelCells& cells) {
  const auto n = static_cast<std::size_t>(cells.unknowns());
  cells.positions.assign(cells.rows.size() * n, -1);
  for (std::size_t begin = 0; begin < cells.rows.size(); begin += n)
    for (std::size_t i = 0; i < n; ++i)
      if (cells.writes[begin + i] != 0)
        for (std::size_t j = 0; j < n; ++j)
          if (cells.rows[begin + j] >= 0)
            cells.positions[(begin + i) * n + j] =
                sparsity.find(cells.rows[begin + i], cells.rows[begin + j]);
}

}  // namespace hawser
