// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/EngineCommands.h"
#include "gpu/engine/BeginWork.h"
#include "gpu/fields/BeforeImages.h"

#include <memory>
#include <optional>

namespace gpu {

/// The one open edit: what was there before, and what becomes of it. What is written is its work's
/// (EditWork), of which it knows no kind. Engine thread only.
class EditTransaction {
public:
    /// Errors: InvalidField; then nothing was changed. Throws GlFailure with everything as it was,
    /// or FieldsLost.
    static core::Result<std::unique_ptr<EditTransaction>> begin(
        EditPrograms& programs, VoxelFields& fields, const core::EngineEdit& edit);

    /// Errors: InvalidField where the extension is of another kind of edit.
    core::Result<void> extend(const core::EngineExtension& extension);
    /// Puts @p next behind @p earlier where extending by both at once comes to the same: pieces of
    /// the open stroke's path. @return whether it did
    [[nodiscard]] bool join(core::EngineExtension& earlier, core::EngineExtension& next) const;

    /// Whether there is more to do that was asked for: steps of a growth, or other work.
    [[nodiscard]] bool hasStepsLeft() const { return m_work && m_work->hasStepsLeft(); }
    [[nodiscard]] double generationsPerSecond() const
    {
        return m_work ? m_work->generationsPerSecond() : 0.0;
    }
    /// Does up to @p rings of them, or so much of that work. Only while there is more to do.
    void advance(int rings) { m_work->advance(rings); }

    /// Closes; fills changes, statistics, generation and atClosure of the result.
    void commit(core::EngineResult& result);
    void rollBack(core::EngineResult& result);
    /// After any of the above threw: puts everything back, and closes. What is asked of it from
    /// then on is refused with @p why. Throws FieldsLost.
    void abandon(const core::Error& why);
    [[nodiscard]] const std::optional<core::Error>& abandoned() const { return m_abandoned; }
    [[nodiscard]] core::GrowthProgress progress() const;

private:
    EditTransaction(EditPrograms& programs, VoxelFields& fields)
        : m_programs(programs)
        , m_fields(fields)
        , m_before(fields)
    {
    }
    core::Result<void> start(const core::EngineEdit& edit);

    EditPrograms& m_programs;
    VoxelFields& m_fields;
    BeforeImages m_before;
    std::unique_ptr<EditWork> m_work; ///< null once abandoned
    std::optional<core::Error> m_abandoned;
};

/// `failure(InvalidField, …)` in short.
[[nodiscard]] tl::unexpected<core::Error> refusal(const char* field, const char* reason);

} // namespace gpu
