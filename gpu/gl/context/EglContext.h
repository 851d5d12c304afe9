// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "gpu/gl/context/GlContext.h"

#include <memory>

namespace gpu {

struct EglContextOptions {
    bool debug = false; ///< a debug context: errors are reported inside the call that made them
};

/// A context without a window: that of the first hardware device of EGL_EXT_platform_device which
/// gives OpenGL 4.5 core, else that of Mesa's surfaceless platform (llvmpipe). If the driver grants
/// it, the context has robust access and reports resets of the graphics processor (ContextLost in
/// gl/GlFailure.h).
class EglContext : public GlContext {
public:
    /// Errors: GraphicsUnavailable("EGL", reason). Any thread; not yet current.
    static core::Result<std::unique_ptr<EglContext>> create(const EglContextOptions& options = {});
    ~EglContext() override;

    bool makeCurrent() override;
    void doneCurrent() override;

private:
    struct Handles;
    explicit EglContext(std::unique_ptr<Handles> handles);
    std::unique_ptr<Handles> m_handles;
};

} // namespace gpu
