#pragma once

#include <string>
#include <vector>

namespace naocal {

class Configuration;
class Thread;

/// Mounts `<module>.json` as `<thread>.<module>` for every module of the thread that has parameters, sets each
/// parameter, and applies later changes between cycles. Returns one sentence per key in a file that no parameter has.
/// Throws ConfigurationError that names thread, module, key and file for a missing key or a wrong type.
std::vector<std::string> configureModules(Thread& thread, Configuration& configuration);

} // namespace naocal
