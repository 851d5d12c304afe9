// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace gpu {

/// An OpenGL 4.5 core context that the engine thread can own. Free of GL, so that ui can adapt
/// Qt's.
class GlContext {
public:
    virtual ~GlContext() = default;

    /// On the calling thread, which keeps it. @return false when the driver refuses
    virtual bool makeCurrent() = 0;
    virtual void doneCurrent() = 0;
};

} // namespace gpu
