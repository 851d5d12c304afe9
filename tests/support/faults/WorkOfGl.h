// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/faults/RedirectedGl.h"

#include <cstdint>

namespace test {

/// What a process asks of the graphics driver. Counts say what a path costs on every machine alike,
/// as times do not.
struct GlWork {
    int dispatches = 0; ///< of compute shaders
    /// Work groups of the dispatches that say how many; those that read it from a buffer
    /// (indirect ones) are not among them.
    std::int64_t groups = 0;
    std::int64_t bytesUp = 0; ///< written to buffers and textures from the program's memory
    std::int64_t bytesDown = 0; ///< read into it
    /// Copied or cleared within the driver; texels of textures count as one byte each.
    std::int64_t bytesWithin = 0;
    std::int64_t bytesMade = 0; ///< of new buffers
    int draws = 0;
    /// Of draws of triangles that fill their place: as many as the scissors, or the whole target.
    std::int64_t pixels = 0;
    bool operator==(const GlWork&) const = default;
};

/// Counts it while the object lives, on all threads. One at a time.
class WorkOfGl {
public:
    WorkOfGl();
    WorkOfGl(const WorkOfGl&) = delete;
    WorkOfGl& operator=(const WorkOfGl&) = delete;

    /// Since the last call. @pre nothing is being done meanwhile
    [[nodiscard]] GlWork take();

private:
    RedirectedGl m_gl;
};

} // namespace test
