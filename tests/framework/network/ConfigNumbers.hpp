#pragma once

namespace naocal {

/// Message types of the configuration's protocol.
enum { set, getMounts, getKeys, save, sendKeys, sendMounts };

} // namespace naocal
