// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace gpu {

/// An OpenGL 4.5 core context that the engine thread can own. This header includes no GL, so that
/// ui can implement it with Qt's context.
class GlContext {
public:
    virtual ~GlContext() = default;

    /// Makes it current on the calling thread, where it then stays.
    /// @return false if the driver refuses
    virtual bool makeCurrent() = 0;
    virtual void doneCurrent() = 0;
};

} // namespace gpu
