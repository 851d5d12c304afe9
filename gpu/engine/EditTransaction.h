// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/EngineCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/kernels/growth/GrowthKernel.h"
#include "gpu/kernels/labels/EraseKernel.h"
#include "gpu/kernels/labels/LabelKernel.h"
#include "gpu/kernels/labels/ShutKernel.h"
#include "gpu/kernels/sculpt/CapsuleKernel.h"
#include "gpu/kernels/sculpt/DrillKernel.h"
#include "gpu/kernels/sculpt/LaserKernel.h"
#include "gpu/kernels/sculpt/PeelKernel.h"
#include "gpu/kernels/sculpt/ScissorsKernel.h"
#include "gpu/kernels/shrink/ShrinkKernel.h"
#include "gpu/kernels/spread/SpreadKernel.h"
#include "gpu/kernels/spread/ToleranceKernel.h"

#include <memory>
#include <optional>

namespace gpu {

/// Every compiled kernel that edits, or works out what an edit would do.
struct EditPrograms {
    explicit EditPrograms(const ShaderLibrary& library)
        : growth(library)
        , mask(library)
        , erase(library)
        , capsule(library)
        , label(library)
        , shut(library)
        , laser(library)
        , spread(library)
        , tolerance(library)
    {
    }

    GrowthPrograms growth;
    MaskPrograms mask;
    ErasePrograms erase;
    CapsulePrograms capsule;
    LabelPrograms label;
    ShutPrograms shut;
    LaserPrograms laser;
    SpreadPrograms spread;
    TolerancePrograms tolerance;
};

/// The one open edit: what it wrote, what was there before, how it goes on. Engine thread only.
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

    /// Steps of a growth that were asked for and not yet done, or work of growing from seeds.
    [[nodiscard]] bool hasStepsLeft() const
    {
        return m_spread ? !m_spread->done() : m_stepsLeft != 0;
    }
    [[nodiscard]] double generationsPerSecond() const { return m_generationsPerSecond; }
    /// Does up to @p rings of them, or so much of that work.
    void advance(int rings);

    /// Closes; fills changes, statistics, generation and atClosure of the result.
    void commit(core::EngineResult& result);
    void rollBack(core::EngineResult& result);
    /// After any of the above threw: puts everything back, and closes. What is asked of it from
    /// then on is refused with @p why. Throws FieldsLost.
    void abandon(const core::Error& why);
    [[nodiscard]] const std::optional<core::Error>& abandoned() const { return m_abandoned; }
    [[nodiscard]] core::GrowthProgress progress() const;

private:
    EditTransaction(GrowthPrograms& growthPrograms, VoxelFields& fields)
        : m_growthPrograms(growthPrograms)
        , m_fields(fields)
        , m_before(fields)
    {
    }
    core::Result<void> start(EditPrograms& programs);
    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const;
    core::Result<void> growAnew(const core::GrowBurst& burst);

    GrowthPrograms& m_growthPrograms;
    VoxelFields& m_fields;
    BeforeImages m_before;
    core::EngineEdit m_edit;
    std::vector<std::uint32_t> m_seedBricks;
    std::vector<core::BrickKey> m_wholeKeys; ///< of an edit that is done once it has begun
    std::uint32_t m_cutTo = 0; ///< generation
    Scissored m_scissored;
    std::optional<GrowthKernel> m_growth;
    std::optional<ShrinkKernel> m_shrink;
    std::optional<DrillKernel> m_drill;
    std::optional<LaserKernel> m_laser;
    std::optional<PeelKernel> m_peel;
    std::optional<CapsuleKernel> m_capsule;
    std::unique_ptr<SpreadKernel> m_spread;
    int m_stepsLeft = 0; ///< negative: to closure
    double m_generationsPerSecond = 0.0;
    std::optional<core::Error> m_abandoned;
};

/// Counts over the changes, as EditStatistics wants them.
[[nodiscard]] core::EditStatistics statisticsOf(const std::vector<core::BrickChange>& changes);

/// Whether an edit could begin in a volume. Errors: InvalidField.
[[nodiscard]] core::Result<void> checkEdit(
    const core::EngineEdit& edit, const core::BrickGrid& grid);
/// Whether a cut of this volume could begin.
[[nodiscard]] core::Result<void> check(const core::CutGrowth& edit, const core::BrickGrid& grid);
/// Whether these groups of seeds are sound and lie in a volume.
[[nodiscard]] core::Result<void> check(
    const std::vector<core::SeedGroup>& groups, const core::BrickGrid& grid);

/// `failure(InvalidField, …)` in short.
[[nodiscard]] tl::unexpected<core::Error> refusal(const char* field, const char* reason);

} // namespace gpu
