// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/cut/GrowthCut.h"
#include "core/growth/cut/LabelMembers.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace core {

/// What a growth becomes when voxels leave it (GrowthCut.h, rules 10 and 11).
/// @param marks for each voxel; LabelCut::leaves is set for those that leave
/// @param retimed new words of members that stay
[[nodiscard]] GrowthCutOutcome cutOutcome(const WordBricks& words, const CutGrowth& command,
    const LeavingVoxels& leaving, const std::vector<std::uint8_t>& marks,
    const std::vector<std::pair<WordBricks::Voxel, std::uint32_t>>& retimed);

/// Determines which members of one label a cut removes, by the rules of GrowthCut.h.
class LabelCut {
public:
    using Voxel = WordBricks::Voxel;
    using Voxels = std::vector<Voxel>;
    /// New words of members that stay.
    using WordChanges = std::vector<std::pair<Voxel, std::uint32_t>>;

    /// @param words, command, marks must outlive this
    /// @param marks one byte per voxel; only those of the label's members are used
    LabelCut(const WordBricks& words, const CutGrowth& command, std::uint32_t label,
        std::vector<std::uint8_t>& marks);

    /// Sets `leaves` in the marks of the voxels that leave.
    /// @param sketch ascending; members that are no roots
    /// @return the voxels that leave, each once
    Voxels run(const Voxels& sketch, WordChanges& changes);
    /// Does the same if the voxels that leave before rule 10 are known already. It may be called
    /// again with more voxels.
    /// @param rim all members that stay although their parent leaves
    Voxels takeOut(Voxels leaving, const Voxels& rim, WordChanges& changes);
    [[nodiscard]] const LabelMembers& members() const { return m_members; }

    static constexpr std::uint8_t leaves = 1;

private:
    class Generations;
    struct Neck {
        std::uint32_t generation = 0;
        std::size_t wide = 0; ///< the numerator of q
        std::uint32_t wideFrom = 0; ///< the lowest later generation that is as wide
    };
    // Further marks:
    static constexpr std::uint8_t onWay = 4;
    static constexpr std::uint8_t beyond = 8;
    /// lies behind the set that behind() was last called for
    static constexpr std::uint8_t liesBehind = 16;
    static constexpr std::uint8_t looked = 32; ///< examined by behind()

    [[nodiscard]] bool has(Voxel voxel, std::uint8_t mark) const
    {
        return (m_marks[voxel] & mark) != 0;
    }
    Voxels leave(Voxels leaving, const Voxels& all, WordChanges& changes);
    Voxels settle(Voxels leaving, const Voxels& staying, WordChanges& changes);
    [[nodiscard]] Voxels orphans(const Voxels& rim);
    [[nodiscard]] std::optional<Voxels> narrowestOf(const Voxels& sketch);
    [[nodiscard]] Voxels near(const Voxels& all, const Voxels& sketch) const;
    void completeFronts(Voxels& front, std::uint8_t mark);
    [[nodiscard]] Generations wayTo(const Voxels& sketch);
    [[nodiscard]] std::vector<Neck> findNecks(Generations& way, const Voxels& sketch);
    [[nodiscard]] static std::vector<Neck> necksOf(
        const Generations& way, const std::vector<std::size_t>& width);
    [[nodiscard]] static bool isNarrowest(const Generations& way, std::uint32_t n);
    [[nodiscard]] Voxels cutAt(const Neck& neck, const Voxels& front);
    [[nodiscard]] Voxels behind(const Voxels& from, std::uint32_t latest);
    void forgetBehind();

    const WordBricks& m_words;
    const CutGrowth& m_command;
    LabelMembers m_members;
    std::vector<std::uint8_t>& m_marks;
    Voxels m_seen; ///< marked by behind() or orphans()
    Voxels m_lost; ///< leave by rule 10 alone
};

} // namespace core
