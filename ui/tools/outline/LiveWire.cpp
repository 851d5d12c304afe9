// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/outline/LiveWire.h"

#include "core/session/EditSession.h"
#include "ui/tools/outline/ReadSlice.h"
#include "ui/workspace/Workspace.h"

#include <algorithm>
#include <utility>

namespace ui {

LiveWire::LiveWire(Workspace& workspace, ReadSlice& slice, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_slice(slice)
{
    connect(&slice, &ReadSlice::dropped, this, &LiveWire::drop);
    connect(&slice, &ReadSlice::arrived, this, &LiveWire::proceed);
}

void LiveWire::drop()
{
    m_background.cancel();
    m_anchors.clear();
    m_ways.clear();
    m_costs.reset();
    m_onwards.reset();
}

void LiveWire::addAnchor(const glm::dvec3& placeLps)
{
    if (m_anchors.empty() && m_window != m_workspace.windowLevel()) {
        m_background.cancel();
        m_costs.reset();
        m_window = m_workspace.windowLevel();
    }
    m_anchors.push_back(m_slice.lattice().cornerAt(placeLps));
    proceed();
}

void LiveWire::removeAnchor()
{
    m_anchors.pop_back();
    if (m_anchors.empty()) {
        m_background.cancel();
        m_ways.clear();
        m_onwards.reset();
        return;
    }
    if (m_ways.size() < m_anchors.size())
        return; // the way to it was not known yet, and what is worked out is wanted still
    m_background.cancel();
    m_ways.pop_back();
    m_onwards.reset();
    proceed();
}

std::size_t LiveWire::anchorCount() const
{
    std::size_t count = 0;
    for (auto anchor = m_anchors.begin(); anchor != m_anchors.end(); ++anchor)
        count += std::find(m_anchors.begin(), anchor, *anchor) == anchor ? 1 : 0;
    return count;
}

bool LiveWire::endsAt(const glm::dvec3& placeLps) const
{
    const glm::ivec2 corner = m_slice.lattice().cornerAt(placeLps);
    return !m_anchors.empty() && (corner == m_anchors.front() || corner == m_anchors.back());
}

/// Does what is to be done next.
void LiveWire::proceed()
{
    if (m_anchors.empty() || !m_slice.pixels() || m_background.busy())
        return;
    if (!m_costs)
        return findCosts();
    while (m_onwards && m_ways.size() + 1 < m_anchors.size()) {
        m_ways.push_back(m_onwards->wayTo(m_anchors[m_ways.size() + 1]));
        if (m_anchors[m_ways.size()] != m_onwards->anchor())
            m_onwards.reset();
    }
    if (!m_onwards)
        findWays();
}

void LiveWire::findCosts()
{
    const core::VoxelEncoding& encoding = m_workspace.volume()->encoding;
    const int low = encoding.lowestCodeAtLeast(m_window.centre - m_window.width / 2.0);
    const int high = encoding.highestCodeAtMost(m_window.centre + m_window.width / 2.0);
    using Costs = std::shared_ptr<const core::SideCosts>;
    const auto find = [pixels = m_slice.pixels(), low, high]() -> Costs {
        return std::make_shared<const core::SideCosts>(core::sideCosts(*pixels, low, high));
    };
    m_background.start(this, find, [this](core::Result<Costs> costs) {
        if (!costs) {
            m_workspace.fail(costs.error());
            Q_EMIT failed();
            return;
        }
        m_costs = *std::move(costs);
        proceed();
    });
}

void LiveWire::findWays()
{
    using Ways = std::shared_ptr<const core::CheapestWays>;
    const auto find = [costs = m_costs, anchor = m_anchors[m_ways.size()]]() -> Ways {
        return std::make_shared<const core::CheapestWays>(costs, anchor);
    };
    m_background.start(this, find, [this](core::Result<Ways> ways) {
        if (!ways) {
            m_workspace.fail(ways.error());
            Q_EMIT failed();
            return;
        }
        m_onwards = *std::move(ways);
        proceed();
        Q_EMIT changed();
    });
}

bool LiveWire::isKnown() const
{
    return m_onwards && m_ways.size() + 1 == m_anchors.size();
}

std::vector<glm::dvec3> LiveWire::placesOf(
    std::vector<glm::ivec2>::const_iterator from, std::vector<glm::ivec2>::const_iterator to) const
{
    std::vector<glm::dvec3> places;
    for (; from != to; ++from)
        places.push_back(m_slice.lattice().cornerLps(*from));
    return places;
}

std::vector<glm::dvec3> LiveWire::wireLps() const
{
    std::vector<glm::ivec2> corners;
    if (!m_anchors.empty())
        corners.push_back(m_anchors.front());
    for (const std::vector<glm::ivec2>& way : m_ways)
        corners.insert(corners.end(), way.begin() + 1, way.end());
    for (std::size_t anchor = m_ways.size() + 1; anchor < m_anchors.size(); ++anchor)
        corners.push_back(m_anchors[anchor]);
    return placesOf(corners.begin(), corners.end());
}

std::vector<glm::ivec2> LiveWire::onwards(const glm::ivec2& corner) const
{
    if (isKnown())
        return m_onwards->wayTo(corner);
    return {m_anchors.back(), corner};
}

std::vector<glm::dvec3> LiveWire::onwardsLps(const glm::dvec3& placeLps) const
{
    if (m_anchors.empty())
        return {};
    const std::vector<glm::ivec2> way = onwards(m_slice.lattice().cornerAt(placeLps));
    return placesOf(way.begin() + 1, way.end());
}

std::vector<glm::dvec3> LiveWire::closingLps() const
{
    const std::vector<glm::ivec2> way = onwards(m_anchors.front());
    // With one anchor there is one corner alone.
    return way.size() < 2 ? std::vector<glm::dvec3>() : placesOf(way.begin() + 1, way.end() - 1);
}

} // namespace ui
