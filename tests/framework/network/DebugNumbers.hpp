#pragma once

namespace naocal {

/// The debug protocol's types of messages.
enum { subscribe, unsubscribe, update, requestList, list, subscribeBulk, image };

} // namespace naocal
