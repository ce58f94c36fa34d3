#pragma once

#include "server/TemporaryDirectory.hpp"

#include <memory>
#include <string>

namespace naocal {

/// Opens an address in a window of its own where a browser can do that, else in the person's browser. The address holds
/// a secret, and what programs were started with is seen by all on this computer: the browser gets a page of a private
/// folder, which leads there. nullptr: no browser was found. The folder is to stay until the browser has read it.
std::unique_ptr<TemporaryDirectory> openInBrowser(const std::string& address);

} // namespace naocal
