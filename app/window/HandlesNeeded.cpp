// SPDX-License-Identifier: Apache-2.0
#include "app/window/HandlesNeeded.h"

#include <QObject>

#include <algorithm>

#include <sys/resource.h>

namespace app {

namespace {

constexpr rlim_t fewest = 64; // a window with a study and its session has 20 open
constexpr rlim_t usual = 1024; // FD_SETSIZE

} // namespace

QString whyNoWindowForHandles()
{
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0)
        return {};
    if (limit.rlim_cur < usual) {
        const rlimit more{std::min(limit.rlim_max, usual), limit.rlim_max};
        if (setrlimit(RLIMIT_NOFILE, &more) == 0)
            limit = more;
    }
    return limit.rlim_cur < fewest
        ? QObject::tr("a window needs %1 file handles, and there may be only %2 (ulimit -n)")
              .arg(fewest)
              .arg(limit.rlim_cur)
        : QString();
}

} // namespace app
