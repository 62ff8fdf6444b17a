#include "src/rows.hpp"

#include <algorithm>
#include <stdexcept>

namespace hawser {
namespace {

std::vector<GlobalIndex> gather(const Communicator& communicator,
                                const std::vector<GlobalIndex>& ids) {
  const auto ranks = static_cast<std::size_t>(communicator.size());
  const int size = static_cast<int>(ids.size());
  std::vector<int> sizes(ranks), starts(ranks + 1, 0);
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator.mpi());
  for (std::size_t i = 0; i < ranks; ++i) {
    starts[i + 1] = starts[i] + sizes[i];
  }
  std::vector<GlobalIndex> all(static_cast<std::size_t>(starts[ranks]));
  MPI_Allgatherv(ids.data(), size, MPI_LONG_LONG, all.data(), sizes.data(), starts.data(),
                 MPI_LONG_LONG, communicator.mpi());
  return all;
}

}  // namespace

Rows::Rows(const Communicator& communicator, GlobalIndex count, const std::vector<GlobalIndex>& ids)
    : count_(count) {
  const bool beyond =
      std::any_of(ids.begin(), ids.end(), [&](GlobalIndex id) { return id >= count; });
  // Only a part of a mesh, such as a cable, is numbered with gaps, and that is small enough to
  // gather.
  if (communicator.any(beyond)) {
    all_ids_ = gather(communicator, ids);
    std::sort(all_ids_.begin(), all_ids_.end());
  }
  const bool repeated = std::adjacent_find(all_ids_.begin(), all_ids_.end()) != all_ids_.end();
  if (repeated || communicator.sum(static_cast<GlobalIndex>(ids.size())) != count) {
    throw std::logic_error("output: every id must be owned by exactly one rank");
  }
  positions_.reserve(ids.size());
  for (const GlobalIndex id : ids) {
    positions_.push_back(position(id));
  }
}

GlobalIndex Rows::position(GlobalIndex id) const {
  if (all_ids_.empty()) return id;
  return std::lower_bound(all_ids_.begin(), all_ids_.end(), id) - all_ids_.begin();
}

}  // namespace hawser
