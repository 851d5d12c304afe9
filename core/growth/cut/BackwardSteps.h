// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/cut/LabelMembers.h"
#include "core/growth/cut/NearerMembers.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// The members of one label that a cut takes backwards, step by step (GrowthCut.h, rule 12). The
/// search of a step costs as much as what it takes; what becomes of the growth is worked out anew
/// from all that leaves (GrowthCut.h).
class BackwardSteps {
public:
    using Voxels = std::vector<WordBricks::Voxel>;

    /// Does the first step.
    /// @param members must outlive this
    /// @param sketch members of which none is a root, each once; not empty
    BackwardSteps(const LabelMembers& members, const Voxels& sketch);

    /// Does one step more. @return false if the steps have ended and it took nothing
    bool advance();
    /// Takes the last step back, which must not be the first. It can be done once for each step.
    void stepBack();

    /// What leaves, each once; what a step takes comes after what those before it took.
    [[nodiscard]] const Voxels& leaving() const { return m_leaving; }
    /// The members that have a parent that leaves, or would by the step that was taken back, and do
    /// not leave; each once.
    [[nodiscard]] const Voxels& rim() const { return m_rim; }
    /// Whether only roots stay.
    [[nodiscard]] bool takesEverything() const { return m_leaving.size() == m_members.grown(); }

private:
    static constexpr std::uint8_t ancestor = 1;
    static constexpr std::uint8_t leaves = 2;
    static constexpr std::uint8_t onRim = 4;

    void takeWithDescendants(const Voxels& ancestors);
    [[nodiscard]] bool isNear(WordBricks::Voxel voxel) const;

    const LabelMembers& m_members;
    NearerMembers m_nearer;
    std::vector<std::uint8_t> m_marks; ///< of each voxel
    Voxels m_leaving;
    Voxels m_rim;
    Voxels m_latest; ///< ancestors that the last step added
    Voxels m_before; ///< those that the step before it added
    std::size_t m_leftBefore = 0; ///< how many left before the last step
};

} // namespace core
