// Sync objects (APPLE_sync) under their names. A GLsync is a pointer in form only: its value is a
// name of the share group's.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/objects.h"

namespace clearpipe::api {

// Null: there is none of that name. Under the lock of the group.
SyncPtr find_sync(const ShareGroup& share, const void* sync);

}  // namespace clearpipe::api
