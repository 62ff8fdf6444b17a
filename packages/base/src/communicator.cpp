#include "hawser/base/communicator.hpp"

#include <algorithm>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

template <class T>
T reduce(MPI_Comm comm, T local, MPI_Datatype type, MPI_Op operation) {
  // MPI_COMM_NULL stands for the one rank of a process that never starts MPI.
  if (comm == MPI_COMM_NULL) return local;
  T global{};
  MPI_Allreduce(&local, &global, 1, type, operation, comm);
  return global;
}

// MPI counts in int.
template <class Work>
void in_pieces(std::size_t size, std::size_t piece, Work&& work) {
  for (std::size_t begin = 0; begin < size; begin += piece)
    work(begin, static_cast<int>(std::min(piece, size - begin)));
}

// The dynamic type is restored so that a caller may catch, say, SolveError on every rank alike.
[[noreturn]] void throw_as(int code, const std::string& message) {
  switch (static_cast<ExitCode>(code)) {
    case ExitCode::deck: throw DeckError(message);
    case ExitCode::mesh: throw MeshError(message);
    case ExitCode::plugin: throw PluginError(message);
    case ExitCode::not_converged: throw SolveError(message);
    case ExitCode::input_output: throw OutputError(message);
    default: throw Error(static_cast<ExitCode>(code), message);
  }
}

}  // namespace

Communicator::Communicator(MPI_Comm comm) : comm_(comm) {
  if (comm_ == MPI_COMM_NULL) return;
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

bool Communicator::any(bool local) const {
  return reduce(comm_, local ? 1 : 0, MPI_INT, MPI_MAX) != 0;
}
double Communicator::sum(double local) const { return reduce(comm_, local, MPI_DOUBLE, MPI_SUM); }
double Communicator::max(double local) const { return reduce(comm_, local, MPI_DOUBLE, MPI_MAX); }
double Communicator::min(double local) const { return reduce(comm_, local, MPI_DOUBLE, MPI_MIN); }
long long Communicator::sum(long long local) const {
  return reduce(comm_, local, MPI_LONG_LONG, MPI_SUM);
}

std::string Communicator::broadcast(const std::string& text) const {
  if (comm_ == MPI_COMM_NULL) return text;
  auto size = static_cast<long long>(text.size());
  MPI_Bcast(&size, 1, MPI_LONG_LONG, 0, comm_);
  std::string result = text;
  result.resize(static_cast<std::size_t>(size));
  in_pieces(result.size(), largest_piece, [&](std::size_t begin, int count) {
    MPI_Bcast(result.data() + begin, count, MPI_CHAR, 0, comm_);
  });
  return result;
}

void Communicator::send(const std::vector<char>& bytes, int to, std::size_t piece) const {
  const auto size = static_cast<long long>(bytes.size());
  MPI_Send(&size, 1, MPI_LONG_LONG, to, 0, comm_);
  in_pieces(bytes.size(), piece, [&](std::size_t begin, int count) {
    MPI_Send(bytes.data() + begin, count, MPI_BYTE, to, 0, comm_);
  });
}

std::vector<char> Communicator::receive(int from, std::size_t piece) const {
  long long size = 0;
  MPI_Recv(&size, 1, MPI_LONG_LONG, from, 0, comm_, MPI_STATUS_IGNORE);
  std::vector<char> bytes(static_cast<std::size_t>(size));
  in_pieces(bytes.size(), piece, [&](std::size_t begin, int count) {
    MPI_Recv(bytes.data() + begin, count, MPI_BYTE, from, 0, comm_, MPI_STATUS_IGNORE);
  });
  return bytes;
}

void Communicator::rethrow_everywhere(int code, const std::string& message) const {
  // The lowest rank that failed speaks for all.
  const int speaker = reduce(comm_, code != 0 ? rank_ : size_, MPI_INT, MPI_MIN);
  if (speaker == size_) return;
  if (comm_ == MPI_COMM_NULL) throw_as(code, message);
  auto size = static_cast<int>(message.size());
  MPI_Bcast(&code, 1, MPI_INT, speaker, comm_);
  MPI_Bcast(&size, 1, MPI_INT, speaker, comm_);
  std::string text = message;
  text.resize(static_cast<std::size_t>(size));
  MPI_Bcast(text.data(), size, MPI_CHAR, speaker, comm_);
  throw_as(code, text);
}

void Communicator::on_root(const std::function<void()>& work) const {
  together([&] {
    if (is_root()) work();
  });
}

void Communicator::together(const std::function<void()>& work) const {
  int code = 0;
  std::string message;
  try {
    work();
  } catch (const Error& error) {
    code = static_cast<int>(error.code());
    message = error.what();
  }
  rethrow_everywhere(code, message);
}

}  // namespace hawser
