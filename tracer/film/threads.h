// Work for a fixed number of threads.
#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace durer::tracer {

/// Calls `work(i)` for i in 0…threads-1, each on a thread of its own as far as possible.
template <typename Work>
void on_threads(int threads, const Work& work) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  arena.execute([&] { tbb::parallel_for(0, threads, work, tbb::simple_partitioner()); });
}

}  // namespace durer::tracer
