// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/labels/LabelScissors.h"
#include "core/sculpt/labels/LabelThreshold.h"
#include "core/sculpt/labels/LayerWrites.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/kernels/labels/EditableBits.h"

#include <map>
#include <string>
#include <vector>

namespace gpu {

/// The compiled kernels that give a label to chosen voxels, or take it (chooseLabel.comp), each
/// when it is first needed, and the one that casts the rays of scissors.
class LabelPrograms {
public:
    /// @param library outlives the programs
    explicit LabelPrograms(const ShaderLibrary& library)
        : m_library(library)
        , m_editable(library)
    {
    }
    /// @param rule by which the shader goes: "SEEN"
    [[nodiscard]] Program& scissorsCast();
    /// @param editable some voxels must not change
    [[nodiscard]] Program& following(const char* rule, bool editable = false);
    /// Whether following() need not compile any more.
    [[nodiscard]] bool isReady(const char* rule, bool editable) const
    {
        return m_known.count(nameOf(rule, editable)) != 0;
    }
    [[nodiscard]] EditableBits& editable() { return m_editable; }

private:
    [[nodiscard]] static std::string nameOf(const char* rule, bool editable)
    {
        return std::string(rule) + (editable ? " EDITABLE" : "");
    }

    const ShaderLibrary& m_library;
    std::map<std::string, Program> m_known; ///< by rule
    Program m_scissorsCast;
    EditableBits m_editable;
};

/// Carries out one of LabelWrites (core/sculpt/labels/LayerWrites.h). Bricks in which something
/// changes are looked for first; only those are captured and written. Returns the keys of what
/// changed. Cost ∝ the bricks that it looks at: those that a layer holds or that are listed, or the
/// volume. Engine thread only.
std::vector<core::BrickKey> writeLabels(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, core::LabelWrites::Pointer edit);

/// The bricks in which a threshold may change something, ascending. Engine thread only.
[[nodiscard]] std::vector<std::uint32_t> bricksConcerned(
    VoxelFields& fields, const core::LabelThreshold& edit);
/// Carries out a threshold in some bricks, as writeLabels() does its edits. Codes are read only
/// where the macro-cells of a brick tell that it holds values inside and outside of the interval.
std::vector<core::BrickKey> writeThreshold(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelThreshold& edit,
    const std::vector<std::uint32_t>& bricks);

/// The same for scissors. Engine thread only.
[[nodiscard]] std::vector<std::uint32_t> bricksConcerned(
    VoxelFields& fields, const core::LabelScissors& edit);
/// Carries scissors out in some bricks. @param reach core::scissorsReach() of each element
std::vector<core::BrickKey> writeScissors(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelScissors& edit, const Buffer& reach,
    const std::vector<std::uint32_t>& bricks);

} // namespace gpu
