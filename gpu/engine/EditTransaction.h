// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/EngineEdit.h"
#include "core/engine/EngineResult.h"
#include "gpu/engine/BeginWork.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/kernels/growth/ComparedGrowth.h"

#include <memory>
#include <optional>
#include <vector>

namespace gpu {

/// The one open edit. It keeps what was there before (BeforeImages) and decides whether the changes
/// are kept or taken back. The voxels are written by its EditWork; the transaction does not know
/// which kind of edit that is. Engine thread only.
class EditTransaction {
public:
    /// Errors: InvalidField; in that case nothing was changed. Throws GlFailure with all voxels as
    /// they were, or FieldsLost.
    static core::Result<std::unique_ptr<EditTransaction>> begin(
        EditPrograms& programs, VoxelFields& fields, const core::EngineEdit& edit);

    /// Errors: InvalidField if the extension belongs to another kind of edit.
    core::Result<void> extend(const core::EngineExtension& extension);
    /// Appends @p next to @p earlier if extending by both at once has the same result as extending
    /// twice, as for two pieces of the path of the open stroke.
    /// @return whether it did
    [[nodiscard]] bool join(core::EngineExtension& earlier, core::EngineExtension& next) const;

    /// Whether requested work is left: growth steps, or other work that runs in slices.
    [[nodiscard]] bool hasStepsLeft() const { return m_work && m_work->hasStepsLeft(); }
    [[nodiscard]] double generationsPerSecond() const
    {
        return m_work ? m_work->generationsPerSecond() : 0.0;
    }
    /// Runs up to @p rings growth steps, or a comparable amount of other work. Call it only while
    /// hasStepsLeft().
    void advance(int rings) { m_work->advance(rings); }

    /// Whether commit() has more to read than it should at once. readSomeChanges() reads a part of
    /// it before, so that the edit can still be rolled back in between. From then on nothing but
    /// the end of the edit may be requested.
    [[nodiscard]] bool hasChangesToRead() const;
    void readSomeChanges();

    /// Closes the edit and keeps its changes. Fills in the changes, statistics, generation and
    /// atClosure of the result. rollBack() closes it and restores every voxel.
    void commit(core::EngineResult& result);
    void rollBack(core::EngineResult& result);
    /// To be called after any of the functions above threw: restores every voxel and closes the
    /// edit. From then on every request to it is refused with @p why. Throws FieldsLost.
    void abandon(const core::Error& why);
    [[nodiscard]] const std::optional<core::Error>& abandoned() const { return m_abandoned; }
    [[nodiscard]] core::GrowthProgress progress() const;
    /// In which plane a growth is open; none if another edit is.
    [[nodiscard]] std::optional<std::uint8_t> growingPlane() const;
    /// Compares that plane with what it was when the growth began. Call it only while one is open.
    [[nodiscard]] ComparedGrowth compareGrowth();

private:
    EditTransaction(EditPrograms& programs, VoxelFields& fields)
        : m_programs(programs)
        , m_fields(fields)
        , m_before(fields)
    {
    }
    core::Result<void> start(const core::EngineEdit& edit);
    void divideChanges();
    void readPart();

    EditPrograms& m_programs;
    VoxelFields& m_fields;
    BeforeImages m_before;
    std::unique_ptr<EditWork> m_work; ///< null after abandon()
    /// The keys whose changes are not read yet; none: they are not known yet.
    std::optional<std::vector<std::vector<core::BrickKey>>> m_unread;
    std::vector<core::BrickChange> m_changes; ///< those that were read
    std::optional<core::Error> m_abandoned;
};

/// Checks whether the edit is valid for a volume, so that it could begin. Errors: InvalidField.
[[nodiscard]] tl::unexpected<core::Error> refusal(const char* field, const core::Clause& reason);

} // namespace gpu
