#pragma once

#include "io/Files.hpp"

#include <memory>
#include <string>

namespace naocal {

/// Opens an address in an app window if the browser supports that, otherwise in the default browser. The address
/// contains a secret, and command lines are readable by every user of this computer: the browser therefore gets a page
/// in a private directory that redirects to it. nullptr if no browser was found. Keep the directory until the browser
/// has read it.
std::unique_ptr<TemporaryDirectory> openInBrowser(const std::string& address);

} // namespace naocal
