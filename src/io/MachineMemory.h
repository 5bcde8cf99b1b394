#pragma once

#include <cstdint>

namespace mpsDem {

/// Memory that this process may still take without swapping [bytes]: what the system has available (MemAvailable of /proc/meminfo), less where
/// a limit of the process (RLIMIT_AS) or of its control group is nearer. The largest number where nothing is known.
[[nodiscard]] std::uint64_t availableMemory();

} // namespace mpsDem
