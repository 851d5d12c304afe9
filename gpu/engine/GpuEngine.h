// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/EditEngine.h"
#include "core/volume/Volume.h"
#include "gpu/engine/LastingFrames.h"

#include <QString>

#include <memory>

namespace gpu {

class GlContext;

/// The engine thread and all that lives on it: one GL 4.5 context, every texture, every kernel, the
/// edit engine and the renderers. The rest of the program talks to the two interfaces.
class GpuEngine {
public:
    /// Starts the thread with its own headless EGL context (first hardware device, else surfaceless
    /// Mesa). Errors: GraphicsUnavailable with the driver's reason, OutOfMemory, ContextLost.
    static core::Result<std::unique_ptr<GpuEngine>> create();
    /// The same with a context of the caller's making that is current nowhere.
    static core::Result<std::unique_ptr<GpuEngine>> create(std::unique_ptr<GlContext> context);
    ~GpuEngine();

    [[nodiscard]] core::EditEngine& edits(); ///< until renew()
    [[nodiscard]] FrameSource& frames(); ///< as long as this
    /// Where and what the codes are, for the renderers; call it beside EditEngine::openVolume().
    void setVolumeGeometry(
        const core::VolumeGeometry& geometry, const core::VoxelEncoding& encoding);

    /// Whether the driver has given the context up (core::ErrorCode::ContextLost): nothing can be
    /// opened, edited or drawn until renew(). Waits for the thread.
    [[nodiscard]] bool isContextLost();
    /// Another thread with a headless context of its own in place of those there are, and a new
    /// edit engine with nothing open; what views had requested they request again. No session is on
    /// the old one any more, and nobody else calls this meanwhile, but for frames(). Waits. Errors:
    /// those of create(); then everything stays as it was.
    core::Result<void> renew();

    [[nodiscard]] QString rendererName() const; ///< GL_RENDERER
    [[nodiscard]] QString versionText() const; ///< GL_VERSION

private:
    class Implementation;
    explicit GpuEngine(std::unique_ptr<Implementation> implementation);
    LastingFrames m_frames; ///< outlives its source
    std::unique_ptr<Implementation> m_implementation;
};

} // namespace gpu
