#pragma once

namespace mpsDem::test {

/// Whether this build is made for speed: what others take says nothing.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
inline constexpr bool optimised = true;
#else
inline constexpr bool optimised = false;
#endif

} // namespace mpsDem::test
