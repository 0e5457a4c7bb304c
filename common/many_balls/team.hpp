#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace bounce::many {

/// Threads that do one piece of work together, again and again. The caller is one of them.
class Team {
 public:
  explicit Team(int size) {
    for (int member = 1; member < size; ++member) {
      threads_.emplace_back([this, member] { serve(member); });
    }
  }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team() {
    work_ = nullptr;
    start();
    for (std::thread& thread : threads_) thread.join();
  }

  int size() const { return static_cast<int>(threads_.size()) + 1; }

  /// Calls work(member) for member 0 to size() - 1, all at the same time, and returns when all have
  /// come back. The work must not throw.
  template <class Work>
  void run(const Work& work) {
    if (threads_.empty()) return work(0);
    // Only this call's lifetime counts, so a reference is enough (and allocates nothing).
    work_ = std::ref(work);
    running_.store(size() - 1, std::memory_order_relaxed);
    start();
    work(0);
    wait([this] { return running_.load(std::memory_order_acquire) == 0; });
  }

 private:
  void start() {
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
  }

  /// A step of ten thousand balls takes less time than waking up a thread that sleeps. So whoever
  /// waits looks again and again, for a moment, before it lets others have the processor.
  template <class Condition>
  static void wait(const Condition& is_met) {
    for (int look = 0; !is_met(); ++look) {
      if (look > 2000) std::this_thread::yield();
    }
  }

  void serve(int member) {
    for (unsigned seen = 0;; ++seen) {
      const auto has_started = [&] { return round_.load(std::memory_order_acquire) != seen; };
      for (int look = 0; !has_started() && look < 20000; ++look) {
        if (look > 2000) std::this_thread::yield();
      }
      round_.wait(seen, std::memory_order_acquire);  // asleep, if it takes longer
      if (!work_) return;
      work_(member);
      running_.fetch_sub(1, std::memory_order_release);
    }
  }

  std::vector<std::thread> threads_;
  std::function<void(int)> work_;
  std::atomic<unsigned> round_{0};
  std::atomic<int> running_{0};
};

}  // namespace bounce::many
