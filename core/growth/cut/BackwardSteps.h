// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/cut/LabelMembers.h"
#include "core/growth/cut/NearerMembers.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// Finds, step by step, the members of one label that a backward cut removes (GrowthCut.h, rule
/// 12). Finding a step costs as much as what it removes; how the growth changes (rules 10 and 11)
/// is not computed here.
class BackwardSteps {
public:
    using Voxels = std::vector<WordBricks::Voxel>;

    /// Carries out the first step.
    /// @param members must outlive this
    /// @param sketch members of which none is a root, each once; not empty
    BackwardSteps(const LabelMembers& members, const Voxels& sketch);

    /// Carries out one more step.
    /// @return false if the steps have ended; then nothing was removed
    bool advance();
    /// Undoes the last step, which must not be the first. Only one step can be undone in a row.
    void stepBack();

    /// The members that leave, each once, in the order of the steps.
    [[nodiscard]] const Voxels& leaving() const { return m_leaving; }
    /// Members that stay although they have a parent that leaves (or that left by a step that was
    /// undone); each once.
    [[nodiscard]] const Voxels& rim() const { return m_rim; }
    /// Whether all members but the roots leave.
    [[nodiscard]] bool takesEverything() const { return m_leaving.size() == m_members.grown(); }

private:
    static constexpr std::uint8_t ancestor = 1;
    static constexpr std::uint8_t leaves = 2;
    static constexpr std::uint8_t onRim = 4;

    void takeWithDescendants(const Voxels& ancestors);
    [[nodiscard]] bool isNear(WordBricks::Voxel voxel) const;

    const LabelMembers& m_members;
    NearerMembers m_nearer;
    std::vector<std::uint8_t> m_marks; ///< for each voxel, the flags above
    Voxels m_leaving;
    Voxels m_rim;
    Voxels m_latest; ///< ancestors that the last step added
    Voxels m_before; ///< those that the step before it added
    std::size_t m_leftBefore = 0; ///< how many left before the last step
};

} // namespace core
