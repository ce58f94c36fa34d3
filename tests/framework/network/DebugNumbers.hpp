#pragma once

namespace naocal {

/// Message types of the debug protocol.
enum { subscribe, unsubscribe, update, requestList, list, subscribeBulk, image };

} // namespace naocal
