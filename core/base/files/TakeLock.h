// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLockFile>

namespace core {

/// Takes a lock that is held for long, for which there is no time after which it is given up. All
/// lock files are taken through this function.
///
/// What a process left that has ended is taken over, as QLockFile does it; and also where that was
/// killed before it wrote into the file who it is, which QLockFile alone would respect for ever.
/// @param waitMs how long to wait for a holder
/// @return whether it is held now; if not, lock.error() says whether another holds it, and errno
/// why it cannot be made
[[nodiscard]] bool takeLock(QLockFile& lock, int waitMs = 0);

} // namespace core
