#include "fuzz/driver/BoundedRead.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

/// libFuzzer's entry point: reads the input with the one reader of this program.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  if (const auto fault = naocal::findFault(*naocal::Reader::all().front(), bytes)) {
    std::fprintf(stderr, "%s\n", fault->c_str());
    std::abort(); // libFuzzer keeps the input
  }
  return 0;
}
