#include "replay_model.hpp"

#include <algorithm>
#include <ctime>
#include <stdexcept>

#include "hawser/simulation/stepper.hpp"

namespace hawser::program {
namespace {

/// The cable's nodes from the tow point on, m, on all ranks. The mesh of a line numbers them so.
std::vector<Place> nodes_of(const Stepper& stepper) {
  const FieldValues moved = stepper.field("displacement");
  const Communicator& world = stepper.run_case().communicator();
  const auto count = static_cast<std::size_t>(world.sum(static_cast<long long>(moved.ids.size())));
  std::vector<Place> nodes(count, Place{0, 0});
  for (std::size_t i = 0; i < moved.ids.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j)
      nodes.at(static_cast<std::size_t>(moved.ids[i]))[j] =
          moved.positions[2 * i + j] + moved.values[2 * i + j];
  MPI_Allreduce(MPI_IN_PLACE, nodes.data(), static_cast<int>(2 * count), MPI_DOUBLE, MPI_SUM,
                world.mpi());
  return nodes;
}

/// Receivers on a cable of equal segments.
std::vector<Place> receivers_on(const std::vector<Place>& nodes, const MeasuredLine& line) {
  std::vector<Place> receivers;
  const double segments = static_cast<double>(nodes.size() - 1);
  for (const double arc : line.arc_lengths) {
    const double along = std::min(arc / line.length(), 1.0) * segments;
    const auto i = std::min(static_cast<std::size_t>(along), nodes.size() - 2);
    const double share = along - static_cast<double>(i);
    receivers.push_back({(1 - share) * nodes[i][0] + share * nodes[i + 1][0],
                         (1 - share) * nodes[i][1] + share * nodes[i + 1][1]});
  }
  return receivers;
}

/// Places at the shots, of what is known at the ends of steps.
class Shots {
 public:
  Shots(const MeasuredLine& line, std::vector<Place> start)
      : line_(line), before_(std::move(start)) {
    positions_.push_back(before_);  // the first shot is where it begins
  }
  void stepped(double time, const std::vector<Place>& now) {
    const double slack = 1e-9 * (time - time_);
    while (positions_.size() < line_.times.size() &&
           line_.times[positions_.size()] <= time + slack) {
      const double share = std::min(1.0, (line_.times[positions_.size()] - time_) / (time - time_));
      std::vector<Place> between = now;
      for (std::size_t r = 0; r < now.size(); ++r)
        for (std::size_t j = 0; j < 2; ++j)
          between[r][j] = (1 - share) * before_[r][j] + share * now[r][j];
      positions_.push_back(std::move(between));
    }
    before_ = now;
    time_ = time;
  }
  Positions take() { return std::move(positions_); }

 private:
  const MeasuredLine& line_;
  std::vector<Place> before_;
  double time_ = 0;
  Positions positions_;
};

}  // namespace

ModelRun run_model(const Environment& environment, const std::string& deck,
                   const std::vector<DeckChange>& changes, const MeasuredLine& line) {
  const std::clock_t begin = std::clock();
  CaseOptions options;
  options.changes = changes;
  Stepper stepper(Case::from_file(environment, deck, options));
  Shots shots(line, receivers_on(nodes_of(stepper), line));
  while (!stepper.finished())
    if (const Attempt attempt = stepper.advance(); attempt.accepted)
      shots.stepped(attempt.time, receivers_on(nodes_of(stepper), line));
  ModelRun run{shots.take(), double(std::clock() - begin) / CLOCKS_PER_SEC, stepper.steps()};
  if (run.positions.size() != line.times.size())
    throw std::logic_error("the run ended before the last shot");
  return run;
}

}  // namespace hawser::program
