// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLockFile>

namespace core {

/// Takes a lock that may be held for long and never expires. All lock files are taken through this
/// function.
///
/// A lock file left behind by a process that has ended is taken over, as by QLockFile; also if that
/// process was killed before it wrote its identity into the file, which QLockFile alone would
/// respect for ever.
/// @param waitMs how long to wait for a holder
/// @return whether it is held now; if not, lock.error() says whether another holds it, and errno
/// why it cannot be made
[[nodiscard]] bool takeLock(QLockFile& lock, int waitMs = 0);

} // namespace core
