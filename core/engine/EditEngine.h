// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/EngineCommands.h"
#include "core/volume/VoxelEncoding.h"

#include <functional>
#include <span>

namespace core {

/// The seam: what can be done to voxels, and nothing about how.
///
/// Commands are carried out in the order of submission; submit() never waits for them. Results are
/// handed out by collect() in that same order, each once. Two implementations: gpu::GpuEditEngine
/// (compute shaders on the engine thread) and the oracle in tests/reference; one conformance suite
/// holds them to equal results, to the bit.
///
/// A result with an error is of a command that has changed nothing: of an edit, as a whole. After
/// EngineLost every command is refused until a volume is opened; after ContextLost for ever, and so
/// is any volume: another engine has to be made. That it came to this is told at once, by a result
/// that bears ticket 0, whether or not anything was asked.
///
/// All members are called from one thread, the session's.
class EditEngine {
public:
    virtual ~EditEngine() = default;

    /// Replace everything by a volume with empty fields. Waits until it is there.
    /// @param codes x fastest, then y, then z; size.x · size.y · size.z of them
    /// Errors: InvalidGeometry (another number of codes, or none), OutOfMemory, ContextLost.
    virtual Result<void> openVolume(
        const glm::ivec3& size, std::span<const std::uint16_t> codes) = 0;

    virtual Ticket submit(EngineCommand command) = 0;
    /// Results that are ready, oldest first; possibly none.
    [[nodiscard]] virtual std::vector<EngineResult> collect() = 0;
    /// Wait until all that was submitted is done (a paced growth runs to its end at once).
    virtual void finish() = 0;

    /// Called on an engine's own thread when collect() has something; set it before submitting.
    virtual void setWakeUp(std::function<void()> wakeUp) = 0;

    [[nodiscard]] virtual GrowthProgress growthProgress() const = 0;
};

/// Begin, tell everything, commit: an edit in one go. Returns the ticket that bears the result.
Ticket submitWhole(
    EditEngine& engine, EngineEdit edit, std::vector<EngineExtension> extensions = {});

} // namespace core
