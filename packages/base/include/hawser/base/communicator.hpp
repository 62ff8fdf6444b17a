#pragma once
// A group of ranks, and the rule that an error on one rank is an error on all.
#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace hawser {

class Communicator {
 public:
  explicit Communicator(MPI_Comm comm = MPI_COMM_WORLD);

  MPI_Comm mpi() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }

  bool any(bool local) const;
  double sum(double local) const;
  double max(double local) const;
  double min(double local) const;
  long long sum(long long local) const;
  std::string broadcast(const std::string& text) const;  ///< from rank 0

  /// Any number of bytes to another rank, which must receive() them, in pieces of the same size:
  /// MPI counts in int.
  void send(const std::vector<char>& bytes, int to, std::size_t piece = largest_piece) const;
  std::vector<char> receive(int from, std::size_t piece = largest_piece) const;

  /// Runs `work` on rank 0 only. An Error thrown there is thrown on every rank, same type and text.
  void on_root(const std::function<void()>& work) const;

  /// Runs `work` on every rank. If it throws an Error anywhere, the Error of the lowest such rank
  /// is thrown on all ranks. `work` must not communicate.
  void together(const std::function<void()>& work) const;

  static constexpr std::size_t largest_piece = 1U << 30U;  ///< bytes in one message

 private:
  void rethrow_everywhere(int code, const std::string& message) const;
  MPI_Comm comm_;
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace hawser
