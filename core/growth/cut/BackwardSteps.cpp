// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/BackwardSteps.h"

#include <utility>

namespace core {

using Voxel = WordBricks::Voxel;

BackwardSteps::BackwardSteps(const LabelMembers& members, const Voxels& sketch)
    : m_members(members)
    , m_nearer(members, sketch)
    , m_marks(members.words().count(), 0)
    , m_latest(sketch)
{
    for (const Voxel voxel : sketch)
        m_marks[voxel] |= ancestor;
    takeWithDescendants(sketch);
}

bool BackwardSteps::isNear(Voxel voxel) const
{
    return !LabelMembers::isRoot(m_members.words()[voxel]) && !m_nearer.nearerToRoots(voxel);
}

bool BackwardSteps::advance()
{
    // The parents of earlier ancestors are ancestors already.
    Voxels next;
    for (const Voxel voxel : m_latest) {
        m_members.forParents(voxel, [&](Voxel parent) {
            if ((m_marks[parent] & ancestor) != 0 || !isNear(parent))
                return;
            m_marks[parent] |= ancestor;
            next.push_back(parent);
        });
    }
    if (next.empty())
        return false;
    m_leftBefore = m_leaving.size();
    takeWithDescendants(next);
    m_before = std::exchange(m_latest, std::move(next));
    return true;
}

void BackwardSteps::takeWithDescendants(const Voxels& ancestors)
{
    std::size_t next = m_leaving.size();
    const auto take = [this](Voxel voxel) {
        if ((m_marks[voxel] & leaves) != 0)
            return;
        m_marks[voxel] |= leaves;
        m_leaving.push_back(voxel);
    };
    for (const Voxel voxel : ancestors)
        take(voxel);
    for (; next < m_leaving.size(); ++next) {
        m_members.forChildren(m_leaving[next], [&](Voxel child) {
            if (isNear(child)) {
                take(child);
            } else if ((m_marks[child] & onRim) == 0) {
                m_marks[child] |= onRim; // it stays whatever comes
                m_rim.push_back(child);
            }
        });
    }
}

void BackwardSteps::stepBack()
{
    for (const Voxel voxel : m_latest)
        m_marks[voxel] &= std::uint8_t(~ancestor);
    for (std::size_t i = m_leftBefore; i < m_leaving.size(); ++i)
        m_marks[m_leaving[i]] &= std::uint8_t(~leaves);
    m_leaving.resize(m_leftBefore);
    m_latest = std::exchange(m_before, {});
}

} // namespace core
