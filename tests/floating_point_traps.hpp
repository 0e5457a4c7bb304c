#pragma once
#include <cfenv>
#if defined(__GLIBC__) && defined(BOUNCE_TRAPS)
#include <dlfcn.h>
#endif

namespace bounce::test {

#if defined(__GLIBC__) && defined(BOUNCE_TRAPS)
inline constexpr int floating_point_errors = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

/// From here on a NaN out of numbers, a division by zero and an overflow end the test with SIGFPE,
/// where they happen, in this thread and in those that it starts. (feenableexcept is glibc's. Clang
/// without -ffp-exception-behavior=maytrap may divide before it asks whether it should; the clang
/// preset has that flag, tests/CMakeLists.txt then defines BOUNCE_TRAPS.) But for a window by an
/// SDL2 that stands on SDL3, which divides by zero inside: that library is then in this program.
inline void trap_floating_point_errors() {
  if (dlopen("libSDL3.so.0", RTLD_LAZY | RTLD_NOLOAD) != nullptr) return;
  feenableexcept(floating_point_errors);
}

/// No traps as long as it lives: for code that means its infinities. Say why beside it.
class WithoutTraps {
 public:
  WithoutTraps() : before_(fedisableexcept(floating_point_errors)) {}
  ~WithoutTraps() {
    std::feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(before_);
  }
  WithoutTraps(const WithoutTraps&) = delete;
  WithoutTraps& operator=(const WithoutTraps&) = delete;

 private:
  int before_;
};
#else
inline void trap_floating_point_errors() {}
struct WithoutTraps {
  WithoutTraps() {}  // so that a variable of it counts as used
};
#endif

}  // namespace bounce::test
