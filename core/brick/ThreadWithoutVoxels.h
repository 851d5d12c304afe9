// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// As long as one stands, the thread that made it must not look at the voxels of bricks: it has a
/// window to serve, and what changed may be hundreds of megabytes. Every look is counted, and in
/// builds with assertions the first one is written to the log as an error, which no test lets pass.
class ThreadWithoutVoxels {
public:
    ThreadWithoutVoxels();
    ~ThreadWithoutVoxels();
    ThreadWithoutVoxels(const ThreadWithoutVoxels&) = delete;
    ThreadWithoutVoxels& operator=(const ThreadWithoutVoxels&) = delete;

    /// How often all such threads have looked so far. Any thread.
    [[nodiscard]] static std::int64_t looks();
};

/// As long as one stands, its thread may look all the same, for a reason that is written beside it.
class VoxelsAllowed {
public:
    VoxelsAllowed();
    ~VoxelsAllowed();
    VoxelsAllowed(const VoxelsAllowed&) = delete;
    VoxelsAllowed& operator=(const VoxelsAllowed&) = delete;
};

/// Called by whatever gives voxels of a brick out. Cheap.
void noteVoxelsLookedAt();

} // namespace core
