#pragma once

#include <string>

namespace naocal {

/// Opens an address in a window of its own where a browser can do that, else in the person's browser. False: no browser
/// was found.
bool openInBrowser(const std::string& address);

} // namespace naocal
