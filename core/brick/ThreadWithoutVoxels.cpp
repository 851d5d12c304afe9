// SPDX-License-Identifier: Apache-2.0
#include "core/brick/ThreadWithoutVoxels.h"

#include "core/base/Log.h"

#include <atomic>
#include <utility>

namespace core {

namespace {

thread_local int forbidding = 0; ///< ThreadWithoutVoxels that stand
thread_local int allowing = 0; ///< VoxelsAllowed that stand
thread_local bool hasComplained = false; ///< since the last ThreadWithoutVoxels was made
std::atomic<std::int64_t> looksSoFar{0};

} // namespace

ThreadWithoutVoxels::ThreadWithoutVoxels()
{
    ++forbidding;
    hasComplained = false;
}

ThreadWithoutVoxels::~ThreadWithoutVoxels()
{
    --forbidding;
}

std::int64_t ThreadWithoutVoxels::looks()
{
    return looksSoFar;
}

VoxelsAllowed::VoxelsAllowed()
{
    ++allowing;
}

VoxelsAllowed::~VoxelsAllowed()
{
    --allowing;
}

void noteVoxelsLookedAt()
{
    if (forbidding == 0 || allowing > 0)
        return;
    ++looksSoFar;
#ifdef _GLIBCXX_ASSERTIONS
    if (!std::exchange(hasComplained, true))
        qCCritical(core::log, "A thread that serves a window looked at the voxels of a brick.");
#endif
}

} // namespace core
