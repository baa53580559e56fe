#pragma once

// A fixed set of workers, each with its own scratch memory, that share the items of a batch.

#include <functional>
#include <memory>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <vector>

namespace gcslab {

template <class Worker>
class WorkerPool {
 public:
  using Maker = std::function<std::unique_ptr<Worker>()>;

  /// With one thread everything runs in the caller's.
  WorkerPool(int threads, const Maker& make)
      : workers_(make), arena_(threads > 1 ? std::make_unique<tbb::task_arena>(threads) : nullptr) {}

  /// Calls work(worker, i) for each i in [0, items), no worker twice at a time.
  template <class Work>
  void run(std::size_t items, const Work& work) {
    if (arena_ == nullptr) {
      for (std::size_t i = 0; i < items; ++i) work(*workers_.local(), i);
      return;
    }
    arena_->execute([&] {
      tbb::parallel_for(std::size_t{0}, items, [&](std::size_t i) { work(*workers_.local(), i); });
    });
  }

 private:
  tbb::enumerable_thread_specific<std::unique_ptr<Worker>> workers_;
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace gcslab
