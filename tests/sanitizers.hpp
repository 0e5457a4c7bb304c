#pragma once

namespace bounce::test {

/// Is this the build with the address sanitizer? It is slow, and keeps what was freed.
#if defined(__SANITIZE_ADDRESS__)  // GCC
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

}  // namespace bounce::test
