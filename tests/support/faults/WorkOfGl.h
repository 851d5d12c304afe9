// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/faults/RedirectedGl.h"

#include <cstdint>

namespace test {

/// Counts of what a process has asked of the graphics driver. Unlike times, they are the same on
/// every machine.
struct GlWork {
    int dispatches = 0; ///< of compute shaders
    /// Work groups of direct dispatches; indirect ones, whose number is in a buffer, are not
    /// counted.
    std::int64_t groups = 0;
    std::int64_t bytesUp = 0; ///< written from the program's memory to buffers and textures
    std::int64_t bytesDown = 0; ///< read into the program's memory
    /// Bytes copied or cleared within the driver; a texel counts as one byte.
    std::int64_t bytesWithin = 0;
    std::int64_t bytesMade = 0; ///< of new buffers
    int draws = 0;
    /// Pixels of array draws, each counted as its scissor box or, without one, as the whole
    /// viewport.
    std::int64_t pixels = 0;
    bool operator==(const GlWork&) const = default;
};

/// Counts during its lifetime, on all threads. Only one may exist at a time.
class WorkOfGl {
public:
    WorkOfGl();
    WorkOfGl(const WorkOfGl&) = delete;
    WorkOfGl& operator=(const WorkOfGl&) = delete;

    /// Returns the counts since the last call. @pre no GL work is under way
    [[nodiscard]] GlWork take();

private:
    RedirectedGl m_gl;
};

} // namespace test
