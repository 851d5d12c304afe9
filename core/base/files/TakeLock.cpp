// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/TakeLock.h"

#include <QString>

namespace core {

namespace {

/// Whether it is locked by somebody who did not write who that is.
bool isNobodys(const QLockFile& lock)
{
    qint64 process = 0;
    QString host;
    QString program;
    return lock.error() == QLockFile::LockFailedError
        && !lock.getLockInfo(&process, &host, &program);
}

} // namespace

bool takeLock(QLockFile& lock, int waitMs)
{
    lock.setStaleLockTime(0);
    if (lock.tryLock(waitMs))
        return true;
    if (!isNobodys(lock))
        return false;
    // Who has just made it is about to write.
    constexpr int writesWithinMs = 200;
    if (lock.tryLock(writesWithinMs))
        return true;
    // A process that lives has the file itself locked, too: then it is not removed.
    return isNobodys(lock) && lock.removeStaleLockFile() && lock.tryLock();
}

} // namespace core
