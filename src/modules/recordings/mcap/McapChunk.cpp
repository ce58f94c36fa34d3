#include "recordings/mcap/McapChunk.hpp"

#include "io/InputError.hpp"

#include <fmt/format.h>
#include <lz4frame.h>
#include <memory>
#include <zlib.h>
#include <zstd.h>

namespace naocal {

namespace {

std::string decompressZstd(std::string_view data, std::size_t size, const std::string& where) {
  std::string result(size, '\0');
  const std::size_t written = ZSTD_decompress(result.data(), result.size(), data.data(), data.size());
  if (ZSTD_isError(written) != 0) {
    throw InputError{fmt::format("{}: expected {} bytes compressed by zstd, found damaged data ({})", where, size,
                                 ZSTD_getErrorName(written))};
  }
  result.resize(written);
  return result;
}

std::string decompressLz4(std::string_view data, std::size_t size, const std::string& where) {
  LZ4F_dctx* created = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&created, LZ4F_VERSION)) != 0) {
    throw std::bad_alloc{};
  }
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context{created,
                                                                                     &LZ4F_freeDecompressionContext};
  std::string result(size, '\0');
  std::size_t written = 0, rest = 1;
  while (rest != 0 && !data.empty()) {
    std::size_t room = size - written, taken = data.size();
    rest = LZ4F_decompress(context.get(), result.data() + written, &room, data.data(), &taken, nullptr);
    if (LZ4F_isError(rest) != 0) {
      throw InputError{fmt::format("{}: expected {} bytes compressed by lz4, found damaged data ({})", where, size,
                                   LZ4F_getErrorName(rest))};
    }
    if (room == 0 && taken == 0) {
      break; // more data than `size`
    }
    written += room;
    data.remove_prefix(taken);
  }
  if (rest != 0) {
    throw InputError{fmt::format("{}: expected a chunk of {} bytes compressed by lz4, found {}", where, size,
                                 data.empty() ? "an end in its middle" : "more")};
  }
  result.resize(written);
  return result;
}

} // namespace

std::string decompressMcapChunk(std::string_view compression, std::string_view data, std::uint64_t size,
                                const std::string& where) {
  std::string result;
  if (compression.empty()) {
    result = data;
  } else if (compression == "zstd") {
    result = decompressZstd(data, size, where);
  } else if (compression == "lz4") {
    result = decompressLz4(data, size, where);
  } else {
    throw InputError{fmt::format("{}: expected the compression zstd, lz4 or none, found \"{}\"", where,
                                 printableText(compression, 40))};
  }
  if (result.size() != size) {
    throw InputError{fmt::format("{}: expected a chunk of {} bytes, found {}", where, size, result.size())};
  }
  return result;
}

std::uint32_t crc32Of(std::string_view data) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(data.data()), data.size())); // NOLINT: bytes
}

} // namespace naocal
