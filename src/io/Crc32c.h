#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mpsDem {

/// CRC-32C (Castagnoli polynomial 0x1EDC6F41, reflected, inverted at both ends), as in RFC 3720, appendix B.4.
/// Finds every single flipped bit and every burst of up to 32 bits.
/// @param before  Checksum of the bytes before these, so that crc32c(b, crc32c(a)) is the checksum of a followed by b.
[[nodiscard]] std::uint32_t crc32c(std::string_view bytes, std::uint32_t before = 0);

/// Eight lower-case hexadecimal digits.
[[nodiscard]] std::string crcText(std::uint32_t crc);

} // namespace mpsDem
