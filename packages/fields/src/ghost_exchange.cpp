#include "src/ghost_exchange.hpp"

#include <numeric>
#include <unordered_map>

namespace hawser {
namespace {

std::vector<int> starts(const std::vector<int>& counts) {
  std::vector<int> result(counts.size(), 0);
  std::partial_sum(counts.begin(), counts.end() - 1, result.begin() + 1);
  return result;
}

std::vector<GlobalIndex> all_to_all(MPI_Comm comm, const std::vector<GlobalIndex>& out,
                                    const std::vector<int>& out_counts,
                                    const std::vector<int>& in_counts) {
  std::vector<GlobalIndex> in(
      static_cast<std::size_t>(std::accumulate(in_counts.begin(), in_counts.end(), 0)));
  const std::vector<int> out_starts = starts(out_counts);
  const std::vector<int> in_starts = starts(in_counts);
  MPI_Alltoallv(out.data(), out_counts.data(), out_starts.data(), MPI_LONG_LONG, in.data(),
                in_counts.data(), in_starts.data(), MPI_LONG_LONG, comm);
  return in;
}

}  // namespace

void exchange_ghosts(const Communicator& communicator, const PointSet& points, std::size_t width,
                     std::vector<GlobalIndex>& values) {
  const auto ranks = static_cast<std::size_t>(communicator.size());
  const auto owned = static_cast<std::size_t>(points.owned);

  // Ask each owner by identifier, ordered by owner.
  std::vector<std::vector<std::size_t>> asked(ranks);
  for (std::size_t p = owned; p < points.ids.size(); ++p)
    asked[static_cast<std::size_t>(points.owners[p])].push_back(p);
  std::vector<GlobalIndex> questions;
  std::vector<int> question_counts(ranks);
  for (std::size_t r = 0; r < ranks; ++r) {
    question_counts[r] = static_cast<int>(asked[r].size());
    for (const std::size_t p : asked[r])
      questions.push_back(points.ids[p]);
  }
  std::vector<int> answer_counts(ranks);
  MPI_Alltoall(question_counts.data(), 1, MPI_INT, answer_counts.data(), 1, MPI_INT,
               communicator.mpi());
  const std::vector<GlobalIndex> wanted =
      all_to_all(communicator.mpi(), questions, question_counts, answer_counts);

  std::unordered_map<GlobalIndex, std::size_t> local;
  for (std::size_t p = 0; p < owned; ++p)
    local.emplace(points.ids[p], p);
  std::vector<GlobalIndex> answers;
  answers.reserve(wanted.size() * width);
  for (const GlobalIndex id : wanted)
    for (std::size_t k = 0; k < width; ++k)
      answers.push_back(values[local.at(id) * width + k]);

  const auto times = [&](std::vector<int> counts) {
    for (int& count : counts)
      count *= static_cast<int>(width);
    return counts;
  };
  const std::vector<GlobalIndex> received =
      all_to_all(communicator.mpi(), answers, times(answer_counts), times(question_counts));
  std::size_t next = 0;
  for (const auto& from : asked)
    for (const std::size_t p : from)
      for (std::size_t k = 0; k < width; ++k)
        values[p * width + k] = received[next++];
}

}  // namespace hawser
