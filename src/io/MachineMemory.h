#pragma once

#include <cstdint>

namespace mpsDem {

/// Memory that this process may still take without swapping [bytes]: what the system has available (MemAvailable of /proc/meminfo), less where
/// a limit of the process (RLIMIT_AS) or of its control group is nearer. The largest number where nothing is known.
[[nodiscard]] std::uint64_t availableMemory();

/// From now on blocks of a megabyte and more have pages of their own, which go back to the system when they are freed. By default the C
/// library keeps them once a large block was freed: what a state took while it was read would stay with the run.
void returnLargeBlocks();

} // namespace mpsDem
