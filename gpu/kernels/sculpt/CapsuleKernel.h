// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/LabelCommands.h"
#include "core/engine/LayerCommands.h"
#include "core/engine/StrokeExtensions.h"
#include "core/sculpt/EdgeRegion.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/kernels/labels/EditableBits.h"
#include "gpu/kernels/work/EditWork.h"

#include <array>
#include <optional>
#include <set>
#include <variant>
#include <vector>

namespace gpu {

/// The compiled kernels of brushes (capsulePaint.comp, capsuleBarrier.comp,
/// capsuleCut.comp).
struct CapsulePrograms {
    /// @param library outlives the programs
    explicit CapsulePrograms(const ShaderLibrary& library);

    Program barrier;
    Program cut;
    /// The kernel of barriers that also restores labels kept as overwritten; compiled when it is
    /// first needed.
    [[nodiscard]] Program& givingBarrier();
    /// Of a brush that follows edges, also compiled when it is first needed: which voxels are
    /// alike (capsuleAlike.comp).
    [[nodiscard]] Program& alike();
    /// The kernel that paints; those for the members of a brush that follows edges, and for strokes
    /// that must leave some voxels alone, are compiled when they are first needed, too.
    [[nodiscard]] Program& paint(bool members, bool editable);
    /// Whether paint() need not compile any more.
    [[nodiscard]] bool isReady(bool members, bool editable) const
    {
        return bool(m_paint.at((members ? 1u : 0u) + (editable ? 2u : 0u)));
    }
    [[nodiscard]] EditableBits& editable() { return m_editable; }

private:
    const ShaderLibrary& m_library;
    Program m_givingBarrier;
    Program m_alike;
    std::array<Program, 4> m_paint; ///< members: 1, editable: 2
    EditableBits m_editable;
};

/// One stroke of a brush while the pen is down: it paints a label (PaintLabel), closes voxels to
/// growth (PaintBarrier) or carves (CapsuleCut). The rules are in core/sculpt/CapsuleSweep.h.
/// extend() processes only the bricks near the new pieces of path, and in each brick only the
/// pieces near it. A brush that follows edges (core/sculpt/EdgeRegion.h) reads which voxels are
/// alike, finds its new members on the processor and paints these. Engine thread only.
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

    /// The keys of all bricks that were changed.
    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const override;

private:
    /// The bricks near some pieces of path, each with the pieces near it.
    struct Candidates {
        std::vector<std::uint32_t> bricks; ///< ascending
        std::vector<std::vector<std::uint32_t>> near; ///< for each brick the indices of pieces
    };
    void follow(const std::vector<core::Capsule>& capsules);
    void extendBy(const std::vector<core::Capsule>& capsules);

    // Of a brush that follows edges (CapsuleEdges.cpp).
    void followEdges(const core::CapsulePath& path);
    void findAlike(const Candidates& candidates, const std::vector<core::Capsule>& capsules);
    void paintMembers(const core::PaintLabel& paint);
    /// Sets which codes voxels may have to count as alike.
    void setEdges(const core::PaintLabel& paint) const;

    /// For a stroke that erases or restores: whether the brick holds nothing that it could remove.
    [[nodiscard]] bool nothingToTakeAway(std::uint32_t brick) const;
    [[nodiscard]] bool nothingFor(const core::PaintLabel& paint, std::uint32_t brick) const;
    [[nodiscard]] bool nothingFor(const core::PaintBarrier& barrier, std::uint32_t brick) const;
    [[nodiscard]] bool nothingFor(const core::CapsuleCut& cut, std::uint32_t brick) const;
    [[nodiscard]] bool has(core::Field field, std::uint8_t plane, std::uint32_t brick) const;
    void setFrame(Program& program) const;
    [[nodiscard]] Program& painting(const core::PaintLabel& paint) const;
    /// Runs a kernel whose textures are bound; returns its flag for each candidate.
    [[nodiscard]] std::vector<std::uint32_t> run(
        Program& program, const Candidates& candidates, const std::vector<core::Capsule>& capsules);
    void write(const core::PaintLabel& paint, const Candidates& candidates,
        const std::vector<core::Capsule>& capsules);
    void write(const core::PaintBarrier& barrier, const Candidates& candidates,
        const std::vector<core::Capsule>& capsules);
    void write(const core::CapsuleCut& cut, const Candidates& candidates,
        const std::vector<core::Capsule>& capsules);
    /// Runs a kernel that writes labels and seed words.
    /// @param newWords it may write seed words in bricks that have none
    void writeLabels(Program& program, std::uint8_t plane, bool newWords,
        const Candidates& candidates, const std::vector<core::Capsule>& capsules);

    CapsulePrograms& m_programs;
    bool m_givesBack = false; ///< it paints a barrier while labels are kept as overwritten
    VoxelFields& m_fields;
    BeforeImages& m_before;
    std::variant<core::PaintLabel, core::PaintBarrier, core::CapsuleCut> m_edit;
    core::CapsuleFrame m_frame;
    std::optional<core::EdgeRegion> m_edges; ///< if it follows edges
    std::set<core::BrickKey> m_touched;
};

} // namespace gpu
