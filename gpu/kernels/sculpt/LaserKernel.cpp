// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/sculpt/LaserKernel.h"

#include "core/engine/EngineResult.h"
#include "gpu/fields/bricks/HiddenBricks.h"
#include "gpu/kernels/work/JoinPieces.h"

#include <algorithm>

namespace gpu {

using core::fixedPoint::floorDivide;
using core::fixedPoint::round14;

namespace {

/// Beams are laid together up to here; bounds what a long path takes.
constexpr std::size_t beamsAtOnce = 64;

struct GpuFoot {
    glm::ivec4 position{0};
    glm::ivec4 sum{0};
};
struct GpuExitBeam {
    glm::ivec4 foot{0};
    glm::ivec4 perStep{0};
};
struct GpuBeam {
    glm::ivec4 perI{0};
    glm::ivec4 perJ{0};
    glm::ivec4 perK{0};
};

Program laserProgram(const ShaderLibrary& library, const char* path)
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = {}});
}

} // namespace

LaserPrograms::LaserPrograms(const ShaderLibrary& library)
    : cast(laserProgram(library, "kernels/cut/surfaceCast.comp"))
    , gradient(laserProgram(library, "kernels/sculpt/laserGradient.comp"))
    , exit(laserProgram(library, "kernels/sculpt/laserExit.comp"))
    , cut(laserProgram(library, "kernels/sculpt/laserCut.comp"))
{
}

LaserKernel::LaserKernel(
    LaserPrograms& programs, VoxelFields& fields, BeforeImages& before, const core::LaserCut& cut)
    : m_programs(programs)
    , m_fields(fields)
    , m_cut(cut)
    , m_caster(programs.cast, fields, cut.frame)
    , m_writer(fields, before, {cut.layer, cut.laying, cut.frame.protectedLabels})
    , m_mask(bufferOf(
          "laser mask", std::vector<std::uint32_t>(cut.mask.values.begin(), cut.mask.values.end())))
{
    m_programs.cut.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("maskFirst", cut.mask.first)
        .set("maskSize", cut.mask.size)
        .set("pitch", cut.frame.pitch)
        .set("rampHalfWidth", cut.frame.rampHalfWidth)
        .set("lift", cut.lift)
        .set("restoring", cut.restore)
        .set("beyond", (cut.frame.front >> 1) + cut.frame.rampHalfWidth);
    m_writer.prepare(m_programs.cut);
    setHidden(m_programs.cut, cut.frame.hidden);
}

core::Result<void> LaserKernel::extend(const core::EngineExtension& extension)
{
    const auto* path = std::get_if<core::DrillPath>(&extension);
    if (!path)
        return EditWork::extend(extension);
    follow(path->samples);
    return {};
}

bool LaserKernel::join(core::EngineExtension& earlier, core::EngineExtension& next) const
{
    return joinPieces(earlier, next, &core::DrillPath::samples);
}

std::vector<core::BrickKey> LaserKernel::touchedKeys() const
{
    return keysOf(core::Field::Coverage, m_cut.layer, m_writer.touchedBricks());
}

void LaserKernel::finish(core::EngineResult& result)
{
    result.statistics.searchedTo = m_caster.searchedTo();
}

void LaserKernel::follow(const std::vector<core::DrillSample>& samples)
{
    std::map<Place, Press> more;
    std::vector<glm::ivec2> fresh;
    for (const core::DrillSample& sample : samples) {
        if (sample.depth <= 0)
            continue;
        const Place place(
            floorDivide(sample.x, m_cut.frame.pitch), floorDivide(sample.y, m_cut.frame.pitch));
        Press& press = more[place];
        press.deepest = std::max(press.deepest, sample.depth);
        press.sum += sample.depth;
    }
    for (const auto& [place, press] : more) {
        const auto [known, isNew] = m_presses.try_emplace(place);
        if (isNew)
            fresh.emplace_back(place.first, place.second);
        known->second.deepest = std::max(known->second.deepest, press.deepest);
        known->second.sum += press.sum;
    }
    const std::size_t before = m_beams.size();
    makeBeams(fresh);
    // A new beam is told of everything before this batch too.
    if (m_cut.mode == core::DrillMode::Rate) {
        for (std::size_t i = before; i < m_beams.size(); ++i) {
            for (const auto& [place, press] : m_presses) {
                const auto now = more.find(place);
                const std::int64_t earlier = press.sum - (now == more.end() ? 0 : now->second.sum);
                m_beams[i].dose += earlier
                    * m_cut.mask.at(m_beams[i].element - glm::ivec2(place.first, place.second));
            }
        }
    }
    const std::vector<std::size_t> deeper = deepen(more);
    for (std::size_t first = 0; first < deeper.size(); first += beamsAtOnce) {
        const std::size_t last = std::min(first + beamsAtOnce, deeper.size());
        lay({deeper.begin() + std::ptrdiff_t(first), deeper.begin() + std::ptrdiff_t(last)});
    }
}

void LaserKernel::makeBeams(const std::vector<glm::ivec2>& elements)
{
    if (elements.empty())
        return;
    const std::vector<core::SurfaceHit> hits = m_caster.cast(elements);
    std::vector<Beam> fresh;
    std::vector<std::int32_t> surfaces;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].zSurface == core::SurfaceHit::none)
            continue;
        fresh.emplace_back().element = elements[i];
        surfaces.push_back(hits[i].zSurface);
    }
    if (fresh.empty())
        return;
    findGradients(fresh, surfaces);
    m_beams.insert(m_beams.end(), fresh.begin(), fresh.end());
}

void LaserKernel::findGradients(std::vector<Beam>& fresh, const std::vector<std::int32_t>& surfaces)
{
    const core::LaserLattice lattice = core::laserLattice(m_cut);
    std::vector<GpuFoot> rows;
    std::vector<glm::ivec4> hidden;
    std::vector<glm::ivec3> feet;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        feet.push_back(core::footPosition(m_cut.frame, fresh[i].element, surfaces[i]));
        rows.push_back({glm::ivec4(feet.back(), 0), glm::ivec4(0)});
        for (const core::IntegerHalfSpace& half : m_cut.frame.hidden)
            hidden.push_back(core::hiddenAround(half, feet.back(), lattice));
    }
    const Buffer footBuffer = bufferOf("laser feet", rows);
    const Buffer hiddenBuffer = bufferOf("laser feet hidden", hidden);
    m_caster.show(m_programs.gradient);
    m_programs.gradient.set("latticeU", lattice.u)
        .set("latticeV", lattice.v)
        .set("latticeW", lattice.w)
        .set("reach", core::LaserCut::normalReach)
        .set("hiddenCount", int(m_cut.frame.hidden.size()));
    footBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    hiddenBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
    m_programs.gradient.dispatch({unsigned(rows.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    footBuffer.read(std::span<GpuFoot>(rows));
    for (std::size_t i = 0; i < fresh.size(); ++i)
        fresh[i].lies =
            core::laserBeam(m_cut.frame, fresh[i].element, surfaces[i], glm::ivec3(rows[i].sum));
    if (!m_cut.frame.throughGaps || m_cut.restore)
        findExits(fresh, feet);
}

void LaserKernel::findExits(std::vector<Beam>& fresh, const std::vector<glm::ivec3>& feet)
{
    const int samples =
        m_cut.restore ? m_cut.frame.sampleCount : m_cut.frame.maxDepth / m_cut.frame.zPerSample + 1;
    std::vector<GpuExitBeam> rows;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        const glm::ivec3 step = core::beamStep(m_cut.frame, fresh[i].lies);
        const core::SeenSamples seen =
            core::seenSamples(m_cut.frame.hidden, feet[i], step, samples);
        rows.push_back({glm::ivec4(feet[i], seen.first), glm::ivec4(step, seen.end)});
    }
    const Buffer beamBuffer = bufferOf("laser exits asked", rows);
    std::vector<std::int32_t> exits(rows.size());
    const Buffer exitBuffer = bufferOf("laser exits", exits);
    m_caster.show(m_programs.exit);
    m_programs.exit.set("restore", m_cut.restore)
        .set("asWhole", false)
        .set("restoring", m_cut.restore);
    m_programs.exit.set("beamCount", unsigned(rows.size()))
        .set("sampleCount", samples)
        .set("gapSamples", m_cut.frame.gapSamples);
    beamBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    exitBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    m_programs.exit.dispatch({unsigned(rows.size() + 63) / 64, 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    exitBuffer.read(std::span<std::int32_t>(exits));
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        if (exits[i] > 0)
            fresh[i].exit = exits[i] * m_cut.frame.zPerSample;
    }
    // Where nothing is carved there is nothing to restore.
    if (m_cut.restore)
        std::erase_if(fresh, [](const Beam& beam) { return beam.exit == core::SurfaceHit::none; });
}

/// Rule 1. The beams that went deeper.
std::vector<std::size_t> LaserKernel::deepen(const std::map<Place, Press>& more)
{
    std::vector<std::size_t> deeper;
    for (std::size_t i = 0; i < m_beams.size(); ++i) {
        Beam& beam = m_beams[i];
        std::int32_t depth = beam.depth;
        if (m_cut.mode == core::DrillMode::Limit) {
            const auto press = more.find({beam.element.x, beam.element.y});
            if (press != more.end())
                depth = std::max(depth, press->second.deepest);
        } else {
            for (const auto& [place, press] : more)
                beam.dose +=
                    press.sum * m_cut.mask.at(beam.element - glm::ivec2(place.first, place.second));
            depth = std::int32_t(std::min<std::int64_t>(m_cut.frame.maxDepth, beam.dose >> 16));
        }
        if (depth == beam.depth)
            continue;
        beam.depth = depth;
        deeper.push_back(i);
    }
    return deeper;
}

std::vector<std::uint32_t> LaserKernel::bricksOf(const Beam& beam) const
{
    const PlaneAxes axes{round14(beam.lies.origin), round14(beam.lies.perI),
        round14(beam.lies.perJ), round14(beam.lies.perK)};
    const int pitch = m_cut.frame.pitch;
    const glm::ivec2 low = m_cut.mask.first * pitch;
    const glm::ivec2 high = (m_cut.mask.first + m_cut.mask.size) * pitch;
    const int r = m_cut.frame.rampHalfWidth;
    int from = -m_cut.lift;
    int to = beam.depth;
    if (m_cut.restore) {
        const int shift = core::restoredFrom(m_cut, beam.exit, beam.depth);
        from = shift == 0 ? from : shift;
        to = shift + beam.depth + (m_cut.frame.front >> 1) + r;
    }
    return bricksUnder(
        axes, m_fields.grid(), {{glm::ivec3(low, from - r), glm::ivec3(high, to + r)}});
}

void LaserKernel::lay(const std::vector<std::size_t>& beams)
{
    std::map<std::uint32_t, std::vector<std::int32_t>> near;
    std::vector<GpuBeam> rows;
    for (const std::size_t number : beams) {
        const Beam& beam = m_beams[number];
        for (const std::uint32_t brick : bricksOf(beam))
            near[brick].push_back(int(rows.size()));
        rows.push_back({glm::ivec4(round14(beam.lies.perI), beam.depth),
            glm::ivec4(round14(beam.lies.perJ),
                m_cut.restore ? core::restoredFrom(m_cut, beam.exit, beam.depth) : beam.exit),
            glm::ivec4(round14(beam.lies.perK), 0)});
    }
    std::vector<std::uint32_t> candidates;
    for (const auto& each : near)
        candidates.push_back(each.first);
    candidates = m_writer.begin(std::move(candidates));
    if (candidates.empty())
        return;
    std::vector<glm::ivec4> spans;
    std::vector<glm::ivec4> visits;
    for (const std::uint32_t brick : candidates) {
        const glm::ivec3 voxel = m_fields.grid().boxOf(int(brick)).minimum;
        const int first = int(visits.size());
        for (const std::int32_t row : near.at(brick)) {
            const core::LaserBeam& lies = m_beams[beams[std::size_t(row)]].lies;
            visits.emplace_back(core::beamBase(lies, voxel), row);
        }
        spans.emplace_back(first, int(visits.size()), int(brick), 0);
    }
    const Buffer spanBuffer = bufferOf("laser candidates", spans);
    const Buffer visitBuffer = bufferOf("laser visits", visits);
    const Buffer beamBuffer = bufferOf("laser beams", rows);
    std::vector<std::uint32_t> flags(candidates.size(), 0);
    const Buffer changedBuffer = bufferOf("laser changed", flags);
    const Buffer hidden = hiddenBases(m_cut.frame.hidden, m_fields.grid(), candidates);
    spanBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    visitBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    beamBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    m_mask.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
    changedBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
    hidden.bindBase(GL_SHADER_STORAGE_BUFFER, 6);
    m_programs.cut.dispatch({unsigned(candidates.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    changedBuffer.read(std::span<std::uint32_t>(flags));
    const std::vector<std::uint32_t> changed = m_writer.end(flags);
    if (changed.empty())
        return;
    m_caster.keepRadiation(changed);
    m_fields.noteChanged(core::Field::Coverage, changed);
}

} // namespace gpu
