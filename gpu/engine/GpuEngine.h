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

/// The engine thread and everything that lives on it: one OpenGL 4.5 context, every texture, every
/// kernel, the edit engine and the renderers. The rest of the program uses its two interfaces,
/// edits() and frames().
class GpuEngine {
public:
    /// Starts the thread with its own headless EGL context (first hardware device, else surfaceless
    /// Mesa). Errors: GraphicsUnavailable with the driver's reason, OutOfMemory, ContextLost.
    static core::Result<std::unique_ptr<GpuEngine>> create();
    /// The same with a context that the caller has made and that is current on no thread.
    static core::Result<std::unique_ptr<GpuEngine>> create(std::unique_ptr<GlContext> context);
    ~GpuEngine();

    [[nodiscard]] core::EditEngine& edits(); ///< valid until renew()
    [[nodiscard]] FrameSource& frames(); ///< valid as long as this object
    /// Tells the renderers where the volume lies in the patient and what its codes mean. Call it
    /// together with EditEngine::openVolume().
    void setVolumeGeometry(
        const core::VolumeGeometry& geometry, const core::VoxelEncoding& encoding);

    /// Whether the driver has taken the context away (core::ErrorCode::ContextLost): then nothing
    /// can be opened, edited or drawn until renew(). Waits for the engine thread.
    [[nodiscard]] bool isContextLost();
    /// Replaces thread, context and edit engine by new ones: a headless context and an engine
    /// without an open volume. Views have to repeat their requests. Beforehand, no session may use
    /// the old engine any more; meanwhile no other thread may call this object, except for
    /// frames(). Waits. Errors: those of create(); then everything stays as it was.
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
