// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/Ticket.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace core {

struct EngineCommand;
struct EngineEdit;
struct EngineExtension;
struct EngineResult;
struct GrowthProgress;

/// The interface between the session and an engine that edits voxels: what can be done, and nothing
/// about how. Who submits a command includes its header (EngineCommands.h has them all), who reads
/// a result EngineResult.h.
///
/// Commands are carried out in the order of submission; submit() never waits. collect() returns
/// their results in the same order, each once. There are two implementations: gpu::GpuEditEngine
/// (compute shaders on its own thread) and the oracle in tests/reference. One conformance suite
/// compares their results bit by bit.
///
/// A command whose result has an error has changed nothing; an edit fails as a whole. After
/// EngineLost every command is refused until a volume is opened. After ContextLost every command
/// and every volume are refused, and another engine must be created. Both are reported at once by a
/// result with ticket 0, even if no command was submitted.
///
/// All members are called from one thread, that of the session.
class EditEngine {
public:
    virtual ~EditEngine() = default;

    /// Replaces everything by a volume whose fields are empty. Blocks until it is loaded.
    /// @param codes x fastest, then y, then z; size.x · size.y · size.z of them
    /// Errors: InvalidGeometry (the number of codes is wrong or 0), OutOfMemory, ContextLost.
    virtual Result<void> openVolume(
        const glm::ivec3& size, std::span<const std::uint16_t> codes) = 0;
    /// The same with codes that nobody else needs: an engine may give their memory back bit by bit
    /// while it takes memory of its own, so that no volume is in memory twice.
    virtual Result<void> takeVolume(const glm::ivec3& size, std::vector<std::uint16_t> codes)
    {
        return openVolume(size, codes);
    }

    virtual Ticket submit(EngineCommand command) = 0;
    /// The results that are ready, oldest first; may be empty.
    [[nodiscard]] virtual std::vector<EngineResult> collect() = 0;
    /// Blocks until all submitted commands are done; a paced growth runs to its end at full speed.
    virtual void finish() = 0;

    /// Gives up an edit whose end was submitted: if work on it is left, that ends soon, and a
    /// commit becomes a rollback. Does not wait. If it comes too late, or if an engine does not do
    /// so, the result lists what changed, and the caller takes it back.
    /// @param ended the ticket of the EndEdit
    virtual void giveUp(Ticket ended) { static_cast<void>(ended); }

    /// @param wakeUp called on a thread of the engine when collect() has results; to be set before
    /// the first submit()
    virtual void setWakeUp(std::function<void()> wakeUp) = 0;

    [[nodiscard]] virtual GrowthProgress growthProgress() const = 0;

    /// Announces that edits with an editable range may follow (EditableVoxels.h), so that an engine
    /// that compiles shaders for them can do so in advance. Does not wait, and changes nothing.
    virtual void expectEditableRanges() { }
};

/// Submits an edit as a whole: begin, all extensions, commit. Returns the ticket of its result.
Ticket submitWhole(EditEngine& engine, EngineEdit edit, std::vector<EngineExtension> extensions);
Ticket submitWhole(EditEngine& engine, EngineEdit edit);

} // namespace core
