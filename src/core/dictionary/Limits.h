#pragma once

#include <cstddef>
#include <cstdint>

#include "core/Errors.h"

namespace mpsDem::dictionary {

inline constexpr int maxIncludeDepth = 16;
inline constexpr int maxNesting = 64;
inline constexpr std::size_t maxExpandedBytes = std::size_t{64} << 20;
inline constexpr std::size_t maxTokens = std::size_t{8} << 20;
inline constexpr std::size_t maxEntries = std::size_t{1} << 18;
inline constexpr std::size_t maxPatterns = 10000;
inline constexpr std::size_t maxWordLength = 1024;
inline constexpr std::size_t maxExpressionLength = 4096;
inline constexpr std::int64_t maxListSize = std::int64_t{8} << 20;

/// What one reading may cost, whatever the text asks for: files, macros and merges all draw on it.
class Budget
{
public:
    void chargeBytes(std::size_t bytes, Location const& where)
    {
        bytes_ += bytes;
        require(bytes_ <= maxExpandedBytes, where, "the dictionary grows beyond 64 MiB when its includes and macros are expanded");
    }
    void chargeTokens(std::size_t tokens, Location const& where)
    {
        tokens_ += tokens;
        require(tokens_ <= maxTokens, where, "the dictionary has more than 8388608 words and numbers", "put bulk data into a field file");
    }
    void chargeEntry(Location const& where) { require(++entries_ <= maxEntries, where, "the dictionary has more than 262144 entries"); }
    void chargePattern(Location const& where)
    {
        require(++patterns_ <= maxPatterns, where, "the dictionary has more than 10000 patterns as keywords");
    }

private:
    std::size_t bytes_ = 0;
    std::size_t tokens_ = 0;
    std::size_t entries_ = 0;
    std::size_t patterns_ = 0;
};

} // namespace mpsDem::dictionary
