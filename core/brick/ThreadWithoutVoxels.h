// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// While an object of this class exists, the thread that created it must not read voxels of bricks:
/// it serves a window, and changed bricks may be hundreds of megabytes. Every access is counted,
/// and in builds with assertions the first one is logged as an error, which makes tests fail.
class ThreadWithoutVoxels {
public:
    ThreadWithoutVoxels();
    ~ThreadWithoutVoxels();
    ThreadWithoutVoxels(const ThreadWithoutVoxels&) = delete;
    ThreadWithoutVoxels& operator=(const ThreadWithoutVoxels&) = delete;

    /// How often such threads have read voxels so far. Any thread.
    [[nodiscard]] static std::int64_t looks();
};

/// While an object of this class exists, its thread may read voxels after all; the reason is stated
/// where it is created.
class VoxelsAllowed {
public:
    VoxelsAllowed();
    ~VoxelsAllowed();
    VoxelsAllowed(const VoxelsAllowed&) = delete;
    VoxelsAllowed& operator=(const VoxelsAllowed&) = delete;
};

/// Called by functions that give access to a brick's voxels. Cheap.
void noteVoxelsLookedAt();

} // namespace core
