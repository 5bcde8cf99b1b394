#include "io/Crc32c.h"

#include <array>
#include <bit>
#include <cstring>

namespace mpsDem {

namespace {

static_assert(std::endian::native == std::endian::little, "eight bytes at a time are taken as a little-endian number");

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

/// tables[k][b]: remainder of byte b followed by k zero bytes.
constexpr Tables makeTables()
{
    Tables tables{};
    for (std::uint32_t b = 0; b < 256; ++b)
    {
        std::uint32_t remainder = b;
        for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1) ? 0x82F63B78u : 0u);
        tables[0][b] = remainder;
    }
    for (std::size_t k = 1; k < 8; ++k)
    {
        for (std::size_t b = 0; b < 256; ++b) tables[k][b] = (tables[k - 1][b] >> 8) ^ tables[0][tables[k - 1][b] & 0xFF];
    }
    return tables;
}

constexpr Tables tables = makeTables();

} // namespace

std::uint32_t crc32c(std::string_view bytes, std::uint32_t before)
{
    std::uint32_t crc = ~before;
    for (; bytes.size() >= 8; bytes.remove_prefix(8))
    {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data(), 8);
        word ^= crc;
        auto const part = [word](unsigned k) { return tables[7 - k][(word >> (8 * k)) & 0xFF]; };
        crc = part(0) ^ part(1) ^ part(2) ^ part(3) ^ part(4) ^ part(5) ^ part(6) ^ part(7);
    }
    for (char const c : bytes) crc = (crc >> 8) ^ tables[0][(crc ^ static_cast<unsigned char>(c)) & 0xFF];
    return ~crc;
}

std::string crcText(std::uint32_t crc)
{
    std::string text(8, '0');
    for (std::size_t i = 8; i-- > 0; crc >>= 4) text[i] = "0123456789abcdef"[crc & 0xF];
    return text;
}

} // namespace mpsDem
