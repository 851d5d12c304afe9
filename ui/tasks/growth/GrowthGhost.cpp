// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/growth/GrowthGhost.h"

#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/coarse/CoarsePassage.h"
#include "core/session/EditSession.h"
#include "core/session/past/SeedStrokes.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/StudyTexts.h"
#include "ui/settings/growth/GrowSettings.h"
#include "ui/tasks/growth/GrowthTurns.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>
#include <QStringList>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

constexpr int slicesAtOnce = 4; ///< asked for; each is a short question, so that edits come between
constexpr int soonMilliseconds = 15;
/// The thread that draws smooths the body for the 3D view, for so many cells in some milliseconds.
constexpr std::size_t mostDrawn = 1 << 18;
constexpr float opacity = 0.3f;

/// Lighter than the segment, which is drawn much alike.
std::uint32_t lighter(std::uint32_t rgb)
{
    std::uint32_t result = 0;
    for (const int shift : {0, 8, 16}) {
        const std::uint32_t channel = rgb >> shift & 0xFFu;
        result |= (channel + (0xFFu - channel) * 2 / 5) << shift;
    }
    return result;
}

/// All codes that a flood takes lie in here.
core::CodeRange codesOf(const core::CoarseRule& rule)
{
    core::CodeRange codes{.lowest = rule.lowCode, .highest = rule.highCode};
    if (!rule.among || rule.among->empty())
        return codes;
    int lowest = codes.highest;
    int highest = codes.lowest;
    for (const core::CodeInterval& interval : *rule.among) {
        lowest = std::min(lowest, interval.low);
        highest = std::max(highest, interval.high);
    }
    return {.lowest = std::max(codes.lowest, lowest), .highest = std::min(codes.highest, highest)};
}

/// @param of the flood
PendingSeeds::Ghost ghostOf(
    core::CoarseReach reach, core::CoarseGrid grid, const core::CoarseRule& of, std::uint32_t rgb)
{
    if (reach.cells.empty())
        return {};
    while (reach.states.size() > mostDrawn) {
        reach = core::inDoubledCells(reach);
        grid.cell *= 2;
    }
    auto areas = std::make_shared<gpu::SceneChunks>();
    areas->box = {reach.cells.minimum * grid.cell,
        glm::min(reach.cells.maximum * grid.cell, grid.volumeSize)};
    areas->cell = grid.cell;
    areas->leaves = std::make_shared<const std::vector<std::uint16_t>>(std::move(reach.states));
    areas->codes = codesOf(of);
    areas->opacity = opacity;
    const std::uint32_t argb = 0xFF000000u | lighter(rgb);
    areas->argb = {argb, argb}; // by core::CoarseReach::State
    auto bodies = std::make_shared<gpu::SceneChunks>(*areas);
    bodies->argb = {argb, 0};
    return {.areas = std::move(areas), .bodies = std::move(bodies)};
}

} // namespace

GrowthGhost::GrowthGhost(Workspace& workspace, QObject* parent, std::int64_t mostCells)
    : QObject(parent)
    , m_workspace(workspace)
    , m_mostCells(mostCells)
    , m_walls(workspace)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(soonMilliseconds);
    connect(&m_soon, &QTimer::timeout, this, &GrowthGhost::advance);
    connect(&workspace, &Workspace::sessionClosing, this, &GrowthGhost::forget);
    connect(&workspace, &Workspace::sessionChanged, this, &GrowthGhost::forget);
    connect(&workspace, &Workspace::activeToolChanged, this, [this] { m_isRefused = false; });
    connect(&m_walls, &GhostWalls::read, this, &GrowthGhost::advance);
    connect(&m_walls, &GhostWalls::refused, this, &GrowthGhost::drop);
    connect(&m_walls, &GhostWalls::lost, this, &GrowthGhost::loseWalls);
}

void GrowthGhost::forget()
{
    drop();
    m_reads.cancel();
    m_reading.reset();
    m_nextLayer = 0;
    m_layersTaken = 0;
    m_isRefused = false;
    m_codes.reset();
    m_askedSeeds.reset();
    m_seeds.reset();
    m_askedMeans.reset();
    m_meansOf.reset();
    m_walls.forget();
}

void GrowthGhost::drop()
{
    m_soon.stop();
    m_wanted.reset();
    m_shown.reset();
    m_isFlooding = false;
    m_floods.cancel();
    m_walls.stop();
    m_workspace.seeds().setGhost({});
    if (std::exchange(m_voxels, std::nullopt))
        Q_EMIT changed();
}

std::optional<GrowthGhost::Wanted> GrowthGhost::present() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return std::nullopt;
    const core::Document& document = session->document();
    const core::Segment* segment = document.segment(m_workspace.activeSegment());
    if (!segment || segment->locked)
        return std::nullopt;
    Wanted wanted{.label = segment->label,
        .plane = segment->plane,
        .rgb = segment->rgb,
        .seeds = m_workspace.seeds().scene(),
        .rule = {}};
    std::bitset<256> seeded; // labels
    for (const gpu::SceneSeed& seed : *wanted.seeds)
        seeded.set(seed.label);
    if (!seeded.test(std::size_t(wanted.label)))
        return std::nullopt;

    // Who grows before it in an interval of its own is not foreseen.
    const std::vector<GrowthTurn> turns = growthTurns(m_workspace);
    const auto turn = std::find_if(turns.begin(), turns.end(),
        [this](const GrowthTurn& each) { return activeGrows(each, m_workspace); });
    if (turn == turns.end())
        return std::nullopt;
    const core::Result<core::GrowBurst> burst =
        core::growBurst(growthOf(*turn, m_workspace), document);
    if (!burst)
        return std::nullopt;
    const core::GrowthRange range = burst->range.value_or(core::GrowthRange());
    core::CoarseRule& rule = wanted.rule;
    rule.lowCode = std::max(burst->lowCode, range.lowCode);
    rule.highCode = std::min(burst->highCode, range.highCode);
    rule.connectivity = burst->connectivity;
    rule.passage = burst->limits.passage;
    if (burst->limits.boxed) {
        rule.boxFrom = burst->limits.boxFrom;
        rule.boxTo = burst->limits.boxTo;
    }
    // What a segment has grown is its own, also where it may be overwritten.
    const GrowthPast::Known& past = m_workspace.seeds().past().of(*session, wanted.plane);
    rule.closed = rule.closedToRivals = ~burst->overwritable | past.grown;
    rule.closed.reset(0).reset(std::size_t(wanted.label));
    rule.closedToRivals.reset(0);
    for (const core::Segment& other : document.segments) {
        const auto label = std::size_t(other.label);
        if (seeded.test(label) && other.plane == wanted.plane && other.label != segment->label
            && !burst->lockedLabels.test(label)) {
            wanted.rivals.set(label);
            rule.closedToRivals.reset(label);
        }
    }
    rule.closed |= range.closed;
    rule.closedToRivals |= range.closed;
    const auto bounds = [&wanted](const core::Segment& other) {
        return other.plane == wanted.plane && other.voxels > 0
            && (wanted.rule.closed.test(other.label)
                || (wanted.rivals.any() && wanted.rule.closedToRivals.test(other.label)));
    };
    wanted.walls = {.plane = wanted.plane,
        .labels = range.closed.any()
            || std::any_of(document.segments.begin(), document.segments.end(), bounds),
        .barriers = past.barriers};
    if (burst->limits.sigmas256 > 0)
        wanted.means = Means{.position = session->history().position(),
            .plane = wanted.plane,
            .interval = {.low = burst->lowCode, .high = burst->highCode},
            .sigmas256 = burst->limits.sigmas256};
    if (burst->limits.onlyVisible) {
        for (const core::SculptLayer& layer : document.layers) {
            if (document.carves(layer))
                wanted.walls.layers.push_back(layer.id);
        }
    }
    return wanted;
}

void GrowthGhost::follow(bool wanted, bool settled)
{
    const core::EditSession* session = m_workspace.session();
    const bool isOpen = session && session->transactionOpen(); // what may take the seeds
    const bool isSettled = settled && m_workspace.seeds().isUpToDate();
    if (wanted && session && !isOpen && !isSettled) {
        if (m_wanted && m_wanted->label != m_workspace.activeSegment())
            drop();
        return;
    }
    std::optional<Wanted> now = wanted && !isOpen ? present() : std::nullopt;
    if (!now) {
        if (m_wanted)
            drop();
        return;
    }
    if (m_wanted == now)
        return;
    if (m_wanted && m_wanted->label != now->label)
        drop(); // until the other one's is known
    m_wanted = std::move(now);
    if (m_voxels)
        advance();
    else
        m_soon.start();
}

/// Begins what is missing for the ghost that is wanted; what is under way calls it again.
void GrowthGhost::advance()
{
    if (!m_wanted || m_isFlooding || !m_workspace.session())
        return;
    if (!m_codes)
        prepare();
    else if (m_askedSeeds != m_wanted->seeds)
        readSeeds();
    else if (!m_seeds)
        return; // they are on their way
    else if (m_wanted->means && m_meansOf != m_wanted->means)
        readMeans();
    else if (const auto read = m_walls.of(m_wanted->walls, m_codes->grid()))
        flood(*read);
}

void GrowthGhost::prepare()
{
    const core::EditSession* session = m_workspace.session();
    if (!session || m_codes || m_reading || m_isRefused)
        return;
    const core::VolumeGeometry& geometry = session->document().volumes.front().geometry;
    m_reading = std::make_shared<core::CoarseCodes>(
        core::CoarseGrid::of(geometry.size, geometry.spacingMm(), m_mostCells));
    m_nextLayer = 0;
    m_layersTaken = 0;
    for (int i = 0; i < slicesAtOnce && m_reading; ++i)
        readSlice();
}

void GrowthGhost::readSlice()
{
    const core::CoarseGrid& grid = m_reading->grid();
    if (m_nextLayer >= grid.size().z)
        return;
    const int layer = m_nextLayer++;
    const int z = grid.sampleOf({0, 0, layer}).z;
    m_workspace.session()->questions().codes(
        {.minimum = {0, 0, z}, .maximum = {grid.volumeSize.x, grid.volumeSize.y, z + 1}},
        [ghost = QPointer<GrowthGhost>(this), reading = m_reading, layer](
            core::Result<std::vector<std::uint16_t>> slice) {
            if (!ghost || ghost->m_reading != reading)
                return;
            if (slice)
                return ghost->takeSlice(layer, std::move(*slice));
            ghost->refuse();
        });
}

/// Silently: a picture or an edit will say why.
void GrowthGhost::refuse()
{
    m_isRefused = true;
    m_reading.reset();
}

void GrowthGhost::takeSlice(int layer, std::vector<std::uint16_t> slice)
{
    m_reads.start(
        this,
        [reading = m_reading, layer, slice = std::move(slice)] {
            reading->takeSlice(layer, slice);
        },
        [this, reading = m_reading](const core::Result<void>& taken) {
            if (m_reading != reading)
                return;
            if (!taken) // memory has run out
                return refuse();
            if (++m_layersTaken < reading->grid().size().z)
                return;
            m_codes = std::move(m_reading);
            m_reading.reset();
            advance();
        });
    readSlice();
}

void GrowthGhost::readSeeds()
{
    m_askedSeeds = m_wanted->seeds;
    m_seeds.reset();
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    std::vector<glm::ivec3> voxels;
    for (const gpu::SceneSeed& seed : *m_askedSeeds)
        voxels.emplace_back(glm::floor(geometry.toIndex(seed.lps) + 0.5));
    m_workspace.session()->questions().probe(voxels,
        [ghost = QPointer<GrowthGhost>(this), asked = m_askedSeeds, voxels](
            const core::Result<std::vector<core::ProbedVoxel>>& probed) {
            if (!ghost || ghost->m_askedSeeds != asked)
                return;
            if (!probed || probed->size() != voxels.size()) {
                ghost->m_askedSeeds.reset(); // so that they are asked about again
                return ghost->drop(); // it is that of other seeds
            }
            ghost->m_seeds.emplace();
            for (std::size_t i = 0; i < voxels.size(); ++i)
                ghost->m_seeds->push_back({.voxel = voxels[i], .code = (*probed)[i].code});
            ghost->advance();
        });
}

void GrowthGhost::readMeans()
{
    if (m_askedMeans)
        return; // its answer asks for the latest
    const core::EditSession& session = *m_workspace.session();
    if (m_wanted->means->position != session.history().position())
        return; // the strokes are others by now: follow() will be called for them
    m_askedMeans = m_wanted->means;
    m_workspace.session()->questions().seedSums(m_askedMeans->plane, m_askedMeans->interval,
        core::seedStrokes(session.history(), session.document(), m_askedMeans->plane),
        [ghost = QPointer<GrowthGhost>(this)](
            const core::Result<std::vector<core::ProbedSeeds>>& means) {
            if (!ghost || !ghost->m_askedMeans)
                return;
            ghost->m_meansOf = std::exchange(ghost->m_askedMeans, std::nullopt);
            if (!means) {
                ghost->m_meansOf.reset();
                return ghost->drop();
            }
            ghost->m_means = *means;
            ghost->advance();
        });
}

void GrowthGhost::loseWalls()
{
    if (!m_wanted)
        return;
    m_shown.reset(); // it is shown until the new one comes, but it is not that of the present walls
    m_floods.cancel();
    m_isFlooding = false;
    advance();
}

void GrowthGhost::flood(const GhostWalls::Read& read)
{
    using Of = core::CoarseSeed::Of;
    m_isFlooding = true;
    std::vector<core::CoarseSeed> seeds;
    for (std::size_t i = 0; i < m_seeds->size(); ++i) {
        const std::uint8_t label = (*m_askedSeeds)[i].label;
        if (int(label) != m_wanted->label && !m_wanted->rivals.test(label))
            continue;
        seeds.push_back((*m_seeds)[i]);
        seeds.back().of = int(label) < m_wanted->label ? Of::RivalBefore
            : int(label) == m_wanted->label            ? Of::Own
                                                       : Of::RivalAfter;
    }
    core::CoarseRule rule = m_wanted->rule;
    if (m_wanted->means) {
        rule.among.emplace();
        rule.rivalsAmong.emplace();
        for (const core::ProbedSeeds& each : m_means) {
            if (int(each.label) == m_wanted->label || m_wanted->rivals.test(each.label))
                (int(each.label) == m_wanted->label ? rule.among : rule.rivalsAmong)
                    ->push_back(core::seedInterval(each.sums, m_wanted->means->sigmas256));
        }
    }
    const auto work = [codes = m_codes, read, seeds = std::move(seeds), rule, rgb = m_wanted->rgb](
                          const core::Progress& progress) -> core::Result<Drawn> {
        core::Result<core::CoarseReach> reach =
            core::coarseFlood(*codes, read.walls(), seeds, rule, progress);
        if (!reach)
            return tl::unexpected(reach.error());
        const std::int64_t voxels = reach->voxels;
        return Drawn{.ghost = ghostOf(std::move(*reach), codes->grid(), rule, rgb),
            .voxels = voxels,
            .tellsWidth = core::CoarsePassage(rule.passage, codes->grid()).isTold()};
    };
    m_floods.start(
        this, work, [this, of = *m_wanted](const core::Result<Drawn>& drawn) { take(of, drawn); });
}

void GrowthGhost::take(const Wanted& of, const core::Result<Drawn>& drawn)
{
    m_isFlooding = false;
    if (!drawn)
        return drop();
    m_shown = of;
    m_voxels = drawn->voxels;
    m_tellsWidth = drawn->tellsWidth;
    m_workspace.seeds().setGhost(drawn->ghost);
    Q_EMIT changed();
    if (m_wanted && !upToDate())
        advance();
}

QString GrowthGhost::words() const
{
    const core::Volume* volume = m_workspace.volume();
    if (!m_voxels || !volume)
        return {};
    if (*m_voxels == 0)
        return tr("nothing");
    const QString size = tr("about %1").arg(millilitreText(*volume, *m_voxels));
    // What it leaves out makes a growth take less, mostly.
    const GrowSettings& settings = m_workspace.growSettings();
    QStringList without;
    if (settings.majority.on || settings.smoothing)
        without += tr("%1, without smoothing");
    if (settings.gradient.on || settings.gradientDifference.on)
        without += tr("%1, without gradients");
    if (settings.difference.on)
        without += tr("%1, without steps");
    if (m_shown && core::isAsked(m_shown->rule.passage) && !m_tellsWidth)
        without += tr("%1, without necks");
    return without.isEmpty()  ? size
        : without.size() == 1 ? without.front().arg(size)
                              : tr("%1, without some criteria").arg(size);
}

} // namespace ui
