// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/kernels/work/EditWork.h"

#include <set>
#include <variant>
#include <vector>

namespace gpu {

/// The compiled kernels of brushes (capsulePaint.comp, capsuleBarrier.comp,
/// capsuleCut.comp).
struct CapsulePrograms {
    /// @param library outlives the programs
    explicit CapsulePrograms(const ShaderLibrary& library);

    Program paint;
    Program barrier;
    Program cut;
    /// Shuts where something lies beneath members; compiled when it is first needed.
    [[nodiscard]] Program& givingBarrier();

private:
    const ShaderLibrary& m_library;
    Program m_givingBarrier;
};

/// One stroke of a brush while the pen is down: paint (PaintLabel), shut to growth (PaintBarrier)
/// or carve (CapsuleCut); rules in core/sculpt/CapsuleSweep.h. It looks at the bricks near the new
/// pieces of path only, and in each brick at the pieces near it. Engine thread only.
class CapsuleKernel final : public EditWork {
public:
    CapsuleKernel(CapsulePrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::PaintLabel& paint);
    CapsuleKernel(CapsulePrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::PaintBarrier& barrier);
    CapsuleKernel(CapsulePrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::CapsuleCut& cut);

    core::Result<void> extend(const core::EngineExtension& extension) override;
    [[nodiscard]] bool join(
        core::EngineExtension& earlier, core::EngineExtension& next) const override;
    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const override;

private:
    /// Bricks near some pieces, each with those that it has to look at.
    struct Candidates {
        std::vector<std::uint32_t> bricks; ///< ascending
        std::vector<std::vector<std::uint32_t>> near; ///< by brick: numbers of pieces
    };
    void follow(const std::vector<core::Capsule>& capsules);
    void extendBy(const std::vector<core::Capsule>& capsules);
    /// Of a stroke that erases or restores: the brick holds nothing.
    [[nodiscard]] bool nothingToTakeAway(std::uint32_t brick) const;
    [[nodiscard]] bool nothingFor(const core::PaintLabel& paint, std::uint32_t brick) const;
    [[nodiscard]] bool nothingFor(const core::PaintBarrier& barrier, std::uint32_t brick) const;
    [[nodiscard]] bool nothingFor(const core::CapsuleCut& cut, std::uint32_t brick) const;
    [[nodiscard]] bool has(core::Field field, std::uint8_t plane, std::uint32_t brick) const;
    void setFrame(Program& program) const;
    /// Runs a kernel whose textures are bound; what it says of each candidate.
    [[nodiscard]] std::vector<std::uint32_t> run(
        Program& program, const Candidates& candidates, const std::vector<core::Capsule>& capsules);
    void write(const core::PaintLabel& paint, const Candidates& candidates,
        const std::vector<core::Capsule>& capsules);
    void write(const core::PaintBarrier& barrier, const Candidates& candidates,
        const std::vector<core::Capsule>& capsules);
    void write(const core::CapsuleCut& cut, const Candidates& candidates,
        const std::vector<core::Capsule>& capsules);
    /// Runs a kernel of labels and seed words. @param newWords it may write words where none were
    void writeLabels(Program& program, std::uint8_t plane, bool newWords,
        const Candidates& candidates, const std::vector<core::Capsule>& capsules);

    CapsulePrograms& m_programs;
    bool m_givesBack = false; ///< a barrier, where something lies beneath members
    VoxelFields& m_fields;
    BeforeImages& m_before;
    std::variant<core::PaintLabel, core::PaintBarrier, core::CapsuleCut> m_edit;
    core::CapsuleFrame m_frame;
    std::set<core::BrickKey> m_touched;
};

} // namespace gpu
