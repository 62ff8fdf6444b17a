#pragma once

namespace hawser {

/// What must run before any matrix or vector is made: MPI and Kokkos, unless they run already, for
/// as long as this object lives.
class ParallelRuntime {
 public:
  ParallelRuntime();
  ~ParallelRuntime();
  ParallelRuntime(const ParallelRuntime&) = delete;
  ParallelRuntime& operator=(const ParallelRuntime&) = delete;

 private:
  bool started_here_;
};

}  // namespace hawser
