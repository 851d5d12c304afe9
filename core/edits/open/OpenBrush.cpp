// SPDX-License-Identifier: Apache-2.0
#include "core/edits/open/OpenBrush.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/open/StrokeExtension.h"

#include <cstdint>
#include <utility>

namespace core {

CapsulePath wholeBrushPath(const BrushPath& path, BrushRule rule, const VolumeGeometry& geometry)
{
    CapsulePath whole{capsules(path, geometry, rule.ofTolerance)};
    if (rule.followsEdges)
        whole.under = voxelsUnder(path, geometry);
    return whole;
}

OpenBrush::OpenBrush(BrushPath& path, BrushRule rule)
    : m_path(path)
    , m_rule(rule)
{
}

OpenStroke::Told OpenBrush::begin(const EngineEdit&, const Document& document, bool)
{
    m_hasBegun = true;
    return {wholeBrushPath(m_path, m_rule, document.volumes.front().geometry)};
}

Result<OpenStroke::Told> OpenBrush::extend(
    const StrokeExtension& extension, const Document& document)
{
    Told told;
    const auto* further = std::get_if<PathPoints>(&extension);
    if (!further || further->pointsLps.empty())
        return told;
    const std::vector<glm::dvec3>& pointsLps = further->pointsLps;
    PartPressures pressed{
        .before = m_path.pressures && !m_path.pressures->empty() ? m_path.pressures->back() : 1.0,
        .ofTolerance = m_rule.ofTolerance};
    pressed.atPoints = continuePressures(m_path.pressures, pointsLps.size(), further->pressures);
    if (m_hasBegun) {
        const glm::dvec3 last = m_path.pointsLps.back();
        const glm::dvec3* from = further->lifted ? nullptr : &last;
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        CapsulePath part{capsules(m_path, geometry, from, pointsLps, pressed)};
        if (m_rule.followsEdges)
            part.under = voxelsUnder(m_path, geometry, from, pointsLps);
        told.push_back(std::move(part));
    }
    if (further->lifted)
        m_path.lifts.push_back(std::int64_t(m_path.pointsLps.size()));
    m_path.pointsLps.insert(m_path.pointsLps.end(), pointsLps.begin(), pointsLps.end());
    return told;
}

} // namespace core
