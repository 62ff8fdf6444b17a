// main() of every test program: each rank runs all tests, rank 0 speaks, any rank's failure counts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mpi.h>

#include <cstdio>

#ifdef HAWSER_TEST_TPETRA
#include <Tpetra_Core.hpp>
using Parallel = Tpetra::ScopeGuard;
#else
struct Parallel {
  Parallel(int* argc, char*** argv) { MPI_Init(argc, argv); }
  ~Parallel() { MPI_Finalize(); }
  Parallel(const Parallel&) = delete;
  Parallel& operator=(const Parallel&) = delete;
};
#endif

namespace {

// What ranks other than 0 print: nothing but their failures.
class FailurePrinter : public testing::EmptyTestEventListener {
 public:
  explicit FailurePrinter(int rank) : rank_(rank) {}
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    std::printf("[rank %d] %s:%d: %s\n", rank_, result.file_name() ? result.file_name() : "?",
                result.line_number(), result.message());
    std::fflush(stdout);
  }

 private:
  int rank_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  Parallel parallel(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) {
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter(rank));  // owned by the listeners
  }
  int result = RUN_ALL_TESTS();
  MPI_Allreduce(MPI_IN_PLACE, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return result;
}
