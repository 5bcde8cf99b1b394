#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/State.h"

namespace mpsDem {

/// What a manifest keeps of a block file.
struct StateFileSummary
{
    std::uint64_t bytes = 0;
    std::uint32_t crc = 0; ///< CRC-32C of the whole file without the checksums of its blocks.
    std::uint64_t blocks = 0;
    std::uint64_t values = 0; ///< Numbers in all blocks together.
};

/// Writes all blocks of a state and forces them onto the device.
///
/// Little endian, every number 8 bytes: "mpsDemS1", number of blocks; then for each block, sorted by name: length of the name, name,
/// kind (0: IEEE double, 1: signed integer), count, values, CRC-32C of all that (as one 8-byte number).
/// @throw CaseError (InputOutput)
StateFileSummary writeStateFile(std::filesystem::path const& path, State const& state);

/// Reads such a file. Sizes are compared with the bytes left before anything is allocated.
/// @throw CaseError (InputOutput) where size, checksum or structure do not match `expected` to the bit.
State readStateFile(std::filesystem::path const& path, StateFileSummary const& expected);

} // namespace mpsDem
