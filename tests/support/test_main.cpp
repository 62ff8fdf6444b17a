// main() of every test program: each rank runs all tests, rank 0 speaks, any rank's failure counts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mpi.h>

#include <cstdio>
#include <filesystem>
#include <string>

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

// The files of tests that run side by side do not meet, nor does one started by hand leave its own
// where it was started: tests/bin/x_test works in tests/run/x.np2.
void enter_own_folder() {
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  const auto name = program.filename().string();
  const auto folder = program.parent_path().parent_path() / "run" /
                      (name.substr(0, name.rfind('_')) + ".np" + std::to_string(ranks));
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  Parallel parallel(&argc, &argv);
  enter_own_folder();
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
