#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace naocal {

/// Decompresses the records of an MCAP chunk. `compression`: "", "zstd" or "lz4" (its frame format). Throws InputError
/// with an explanation that completes "`where`: ": unknown compression, damaged data, another size than `size`.
std::string decompressMcapChunk(std::string_view compression, std::string_view data, std::uint64_t size,
                                const std::string& where);

/// CRC-32 (IEEE 802.3), the checksum of MCAP's chunks.
std::uint32_t crc32Of(std::string_view data);

} // namespace naocal
