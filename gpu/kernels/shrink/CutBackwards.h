// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/cut/BackwardCut.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace gpu {

/// An open cut that takes a growth back from a sketch, generation by generation
/// (core/growth/cut/GrowthCut.h, rule 12). As in CutGrown.h the seed words are read back once and
/// the CPU computes the result. After each further step only the bricks that it changes are
/// written. Engine thread only.
class CutBackwards {
public:
    /// Reads the growth and carries out the first steps of the command. Errors: those of
    /// core::BackwardCut::begin(); nothing is changed then.
    static core::Result<std::unique_ptr<CutBackwards>> begin(
        VoxelFields& fields, BeforeImages& before, const core::CutGrowth& command);

    /// Carries out further steps, up to this number in all.
    void advanceTo(std::uint32_t steps);

    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const
    {
        return {m_touched.begin(), m_touched.end()};
    }
    [[nodiscard]] std::uint32_t generation() const { return m_generation; }
    [[nodiscard]] core::BackwardProgress progress() const { return m_cut->progress(); }

private:
    CutBackwards(VoxelFields& fields, BeforeImages& before, std::uint8_t plane);
    void write();

    VoxelFields& m_fields;
    BeforeImages& m_before;
    std::uint8_t m_plane;
    core::WordBricks m_words; ///< seed words from before the cut
    std::unique_ptr<core::BackwardCut> m_cut;
    std::map<std::uint32_t, core::CutBrick> m_written; ///< bricks as written last, by number
    std::set<core::BrickKey> m_touched;
    std::uint32_t m_generation = 0;
};

} // namespace gpu
