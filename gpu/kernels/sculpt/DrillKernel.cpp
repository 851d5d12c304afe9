// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/sculpt/DrillKernel.h"

#include "core/engine/EngineResult.h"
#include "gpu/kernels/work/JoinPieces.h"

#include <algorithm>
#include <limits>

namespace gpu {

namespace {

constexpr int tileSide = CutColumns::tileSide;
/// Samples are worked off together up to here; bounds what a long path takes.
constexpr std::size_t touchesAtOnce = 1 << 20;

} // namespace

DrillKernel::DrillKernel(
    CutPrograms& programs, VoxelFields& fields, BeforeImages& before, const core::DrillCut& cut)
    : m_fields(fields)
    , m_cut(cut)
    , m_columns(cut.frame, fields.grid())
    , m_caster(programs.cast, fields, cut.frame)
    , m_cutter(programs.cut, fields, before, cut.frame,
          {cut.layer, cut.laying, cut.frame.protectedLabels})
{
}

DrillKernel::Element& DrillKernel::element(const glm::ivec2& at)
{
    std::vector<Element>& tile = m_tiles[{at.x >> 4, at.y >> 4}];
    if (tile.empty())
        tile.resize(std::size_t(tileSide) * tileSide);
    return tile[std::size_t((at.x & 15) + tileSide * (at.y & 15))];
}

DrillKernel::Press DrillKernel::press(const core::DrillSample& sample)
{
    Press press{sample, {}};
    const core::ElementBox box = core::elementsUnder(m_cut, sample);
    const glm::ivec2 low = glm::max(box.minimum, m_columns.room().minimum);
    const glm::ivec2 high = glm::min(box.maximum, m_columns.room().maximum);
    for (int b = low.y; b <= high.y; ++b) {
        for (int a = low.x; a <= high.x; ++a) {
            const std::int32_t weight = core::maskWeight(m_cut, sample, {a, b});
            if (weight == 0)
                continue;
            Element& at = element({a, b});
            if (!at.cast) {
                at.at = {a, b};
                at.cast = true;
                m_uncast.push_back(&at);
            }
            press.touched.push_back({&at, weight});
        }
    }
    return press;
}

void DrillKernel::castNew()
{
    std::vector<glm::ivec2> elements;
    for (const Element* element : m_uncast)
        elements.push_back(element->at);
    const std::vector<core::SurfaceHit> hits = m_caster.cast(elements);
    for (std::size_t i = 0; i < hits.size(); ++i)
        m_uncast[i]->hit = hits[i];
    m_uncast.clear();
}

/// Rule 1c.
std::int32_t DrillKernel::farthestSurface(const Press& press) const
{
    if (m_cut.guard < 0)
        return core::SurfaceHit::none;
    std::vector<std::int32_t> surfaces;
    for (const Touch& touch : press.touched) {
        if (touch.element->hit.zSurface != core::SurfaceHit::none)
            surfaces.push_back(touch.element->hit.zSurface);
    }
    if (surfaces.empty())
        return core::SurfaceHit::none;
    const auto median = surfaces.begin() + (std::ssize(surfaces) - 1) / 2;
    std::nth_element(surfaces.begin(), median, surfaces.end());
    return *median + m_cut.guard;
}

void DrillKernel::deepen(const Press& press)
{
    const std::int32_t farthest = farthestSurface(press);
    for (const Touch& touch : press.touched) {
        Element& at = *touch.element;
        if (at.hit.zSurface == core::SurfaceHit::none || at.hit.zSurface > farthest)
            continue;
        const std::int64_t more = core::contribution(m_cut, press.sample, touch.weight);
        at.sum += more;
        const std::int32_t depth = m_cut.mode == core::DrillMode::Rate
            ? std::int32_t(std::min<std::int64_t>(m_cut.frame.maxDepth, at.sum >> 16))
            : std::max(at.depth, std::int32_t(more));
        if (depth == at.depth)
            continue;
        at.depth = depth;
        m_columns.set(at.at, core::drillColumn(m_cut.frame, at.hit, depth));
    }
}

core::Result<void> DrillKernel::extend(const core::EngineExtension& extension)
{
    const auto* path = std::get_if<core::DrillPath>(&extension);
    if (!path)
        return EditWork::extend(extension);
    follow(path->samples);
    return {};
}

bool DrillKernel::join(core::EngineExtension& earlier, core::EngineExtension& next) const
{
    return joinPieces(earlier, next, &core::DrillPath::samples);
}

std::vector<core::BrickKey> DrillKernel::touchedKeys() const
{
    return keysOf(core::Field::Coverage, m_cut.layer, m_cutter.touchedBricks());
}

void DrillKernel::finish(core::EngineResult& result)
{
    result.statistics.searchedTo = m_caster.searchedTo();
}

void DrillKernel::follow(const std::vector<core::DrillSample>& samples)
{
    for (std::size_t next = 0; next < samples.size();) {
        std::vector<Press> presses;
        for (std::size_t touches = 0; next < samples.size() && touches < touchesAtOnce; ++next) {
            if (samples[next].depth > 0)
                touches += presses.emplace_back(press(samples[next])).touched.size();
        }
        castNew();
        for (const Press& each : presses)
            deepen(each);
    }
    const std::vector<std::uint32_t> changed = m_cutter.lay(m_columns);
    if (changed.empty())
        return;
    m_caster.keepRadiation(changed);
    m_fields.noteChanged(core::Field::Coverage, changed);
}

} // namespace gpu
