#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <system_error>
#include <thread>
#include <vector>

namespace bounce::many {

/// Threads that do one piece of work together, again and again. The caller is one of them.
class Team {
 public:
  explicit Team(int size) : next_(static_cast<std::size_t>(size)) {
    for (int member = 1; member < size; ++member) {
      try {
        threads_.emplace_back([this, member] { serve(member); });
      } catch (const std::system_error&) {
        break;  // with as many as there are: in a web page none
      }
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

  /// Calls work(piece) for each piece from 0 to `pieces` - 1. Each member begins with the same ones
  /// every time, which its cache still knows; who is done early helps the others.
  template <class Work>
  void share_out(int pieces, const Work& work) {
    const auto begin_of = [&](int member) { return pieces * member / size(); };
    for (int member = 0; member < size(); ++member) {
      next_[static_cast<std::size_t>(member)].piece = begin_of(member);
    }
    run([&](int member) {
      for (int i = 0; i < size(); ++i) {
        const int owner = (member + i) % size();
        std::atomic<int>& next = next_[static_cast<std::size_t>(owner)].piece;
        for (int piece; (piece = next.fetch_add(1)) < begin_of(owner + 1);) work(piece);
      }
    });
  }

 private:
  struct alignas(64) Next {  // a line of the cache for each: they are written all the time
    std::atomic<int> piece{0};
  };

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

  std::vector<Next> next_;  // of each member's pieces
  std::vector<std::thread> threads_;
  std::function<void(int)> work_;
  std::atomic<unsigned> round_{0};
  std::atomic<int> running_{0};
};

}  // namespace bounce::many
