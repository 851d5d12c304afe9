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

/// The kernels that give a label to chosen voxels or take it away (chooseLabel.comp), and the one
/// that casts the rays of scissors. Each is compiled when it is first needed.
class LabelPrograms {
public:
    /// @param library outlives the programs
    explicit LabelPrograms(const ShaderLibrary& library)
        : m_library(library)
        , m_editable(library)
    {
    }
    /// The kernel that casts the rays of scissors (scissorsCast.comp).
    [[nodiscard]] Program& scissorsCast();
    /// The kernel of a rule.
    /// @param rule the macro that chooses the rule in the shader: "SEEN"
    /// @param editable the variant that leaves voxels outside an editable range alone
    [[nodiscard]] Program& following(const char* rule, bool editable = false);
    /// Whether following() has compiled this kernel already.
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

/// Carries out one of LabelWrites (core/sculpt/labels/LayerWrites.h) and returns the keys of what
/// has changed. Bricks in which something would change are found first; only those are captured and
/// written. Cost: proportional to the bricks that are examined: those that a layer holds, or those
/// that are listed. Engine thread only.
std::vector<core::BrickKey> writeLabels(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, core::LabelWrites::Pointer edit);

/// Returns the bricks in which a threshold may change something, ascending: those that may hold a
/// value in the interval, and those in which the segment may lose something. Engine thread only.
[[nodiscard]] std::vector<std::uint32_t> bricksConcerned(
    VoxelFields& fields, const core::LabelThreshold& edit);
/// Carries out a threshold in some bricks and returns the keys of what has changed. Codes are read
/// only in bricks whose macro-cells hold values both inside and outside of the interval.
std::vector<core::BrickKey> writeThreshold(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelThreshold& edit,
    const std::vector<std::uint32_t>& bricks);

/// Returns the bricks in which a table of labels may change something, ascending: all of the volume
/// if it gives free voxels to a segment, else those that may hold labels. Engine thread only.
[[nodiscard]] std::vector<std::uint32_t> bricksConcerned(
    LabelPrograms& programs, VoxelFields& fields, const core::MapLabels& edit);
/// Replaces labels in some bricks and returns the keys of what has changed.
std::vector<core::BrickKey> writeMapped(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::MapLabels& edit, const std::vector<std::uint32_t>& bricks);

/// Returns the bricks in which scissors may change something, ascending: those under the curve that
/// may hold a value in the interval. Engine thread only.
[[nodiscard]] std::vector<std::uint32_t> bricksConcerned(
    VoxelFields& fields, const core::LabelScissors& edit);
/// Carries out scissors in some bricks and returns the keys of what has changed. @p reach is
/// core::scissorsReach() of each element of the mask.
std::vector<core::BrickKey> writeScissors(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelScissors& edit, const Buffer& reach,
    const std::vector<std::uint32_t>& bricks);

} // namespace gpu
