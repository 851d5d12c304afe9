// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/Chunks.h"

#include "core/chunks/BoxWalk.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/masks/ReadProbabilities.h"
#include "core/session/SessionChunks.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/settings/ChunkShades.h"
#include "ui/settings/CoarseScene.h"
#include "ui/texts/MaskTexts.h"
#include "ui/workspace/Workspace.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ui {

namespace {

/// Rims of chunks that are likely to be added, and to be taken.
constexpr std::uint32_t addRim = 0xFF8CFFA0;
constexpr std::uint32_t takeRim = 0xFFFF8070;

} // namespace

Chunks::Chunks(Workspace& workspace)
    : QObject(&workspace)
    , m_workspace(workspace)
    , m_members(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_background.cancel();
        m_reading.cancel();
        m_wanted.reset();
        m_leaves.reset();
        m_members.begin(nullptr, 0);
        m_likely.forget();
        m_lit.clear();
        m_takesSuggestion = m_isAwaited = false;
        m_dividedAfter = std::numeric_limits<core::RowId>::max();
        if (m_look.shown) {
            m_look.shown = false;
            Q_EMIT lookChanged();
        }
        colour(); // no chunks of the last study are drawn over the next one
        follow();
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Chunks
                || change.what == core::DocumentChange::What::Segments)
                follow();
            else if (change.what == core::DocumentChange::What::Labels)
                m_members.look(change.box);
        });
    connect(&m_members, &ChunkMembers::changed, this, [this] {
        colour();
        Q_EMIT changed();
    });
    connect(&m_members, &ChunkMembers::counted, this, [this] {
        if (std::exchange(m_coarse, nullptr))
            colour();
        lookForLikely();
    });
    connect(&m_likely, &LikelyChunks::changed, this, [this] {
        colour();
        Q_EMIT changed();
    });
}

std::optional<core::ChunkDivision> Chunks::division() const
{
    const core::EditSession* session = m_workspace.session();
    return session ? session->document().chunks : std::nullopt;
}

bool Chunks::isWorking() const
{
    return m_look.shown && division() && !m_leaves;
}

core::SessionChunks* Chunks::chunks() const
{
    core::EditSession* session = m_workspace.session();
    return session ? &session->chunks() : nullptr;
}

core::ChunkStage Chunks::stage() const
{
    const core::SessionChunks* its = chunks();
    // The rest is done here.
    return (its ? its->stage() : std::nullopt)
        .value_or(core::ChunkStage{.step = core::ProgressStep::ColouringChunks, .percent = 100});
}

void Chunks::follow()
{
    const std::optional<core::ChunkDivision> now = division();
    std::shared_ptr<const core::ChunkMap> wanted;
    std::shared_ptr<const core::CoarseChunks> coarse;
    if (now && m_look.shown) {
        core::SessionChunks& its = m_workspace.session()->chunks();
        wanted = its.map();
        if (!wanted && its.whyNot())
            return takeBack(); // the session says why
        coarse = its.coarse();
    }
    const int id = now ? now->id : 0;
    const bool isOther = std::exchange(m_division, id) != id && std::exchange(m_coarse, nullptr);
    // Those of before stay while what is seen of the chunks is worked out.
    const bool isCoarseNew = (!wanted && std::exchange(m_coarse, coarse) != coarse) || isOther;
    if (wanted != m_wanted || (now && now->segment != m_segment)) {
        m_segment = now ? now->segment : 0;
        m_wanted = std::move(wanted);
        m_leaves.reset();
        m_specks = 0;
        m_count = 0;
        m_lit.clear();
        m_likely.forget();
        m_members.begin(nullptr, 0);
        colour();
        m_background.cancel();
        if (m_wanted)
            m_background.start(
                this,
                [map = m_wanted, segment = m_segment] {
                    return std::make_shared<const ChunkLeaves>(map, segment);
                },
                [this](const core::Result<std::shared_ptr<const ChunkLeaves>>& leaves) {
                    if (leaves)
                        return take(*leaves);
                    takeBack();
                    m_workspace.fail(leaves.error());
                });
    } else if (isCoarseNew) {
        colour();
    }
    Q_EMIT changed();
}

void Chunks::take(const std::shared_ptr<const ChunkLeaves>& leaves)
{
    m_leaves = leaves;
    const core::ChunkTree& tree = m_leaves->map->tree();
    m_specks = specksOf(tree);
    m_members.begin(m_leaves, m_segment);
    if (!m_members.isCounting())
        m_coarse.reset();
    const bool takesSuggestion = std::exchange(m_takesSuggestion, false);
    const bool isNew = std::exchange(m_isAwaited, false) && isJustDivided();
    if (const core::Segment* segment = m_workspace.session()->document().segment(m_segment);
        isNew && segment)
        m_workspace.say(tr("%1 and what lies around it is divided: a click adds a chunk or takes "
                           "it away")
                            .arg(segment->name));
    if (const auto suggested = suggestedCount(); isNew && takesSuggestion && suggested) {
        Look look = m_look;
        look.count = *suggested;
        setLook(look);
    }
    colour();
    Q_EMIT changed();
}

/// Whether the present division is the last that divide() made, and not one that was gone back to.
bool Chunks::isJustDivided() const
{
    const core::History& history = m_workspace.session()->history();
    const std::vector<core::RowId> path = history.pathTo(history.position());
    const auto last = std::find_if(path.rbegin(), path.rend(),
        [&history](core::RowId row) { return history.row(row).edit.is<core::DivideSegment>(); });
    return last != path.rend() && *last > m_dividedAfter;
}

std::optional<int> Chunks::suggestedCount() const
{
    if (!m_leaves || !m_leaves->suggestedCount)
        return std::nullopt;
    return std::clamp(*m_leaves->suggestedCount - m_specks, fewest, most);
}

glm::dvec3 Chunks::placeLps(const Likely& likely) const
{
    const core::VoxelBox& box = m_leaves->map->box();
    const core::BoxWalk walk(box.maximum - box.minimum);
    return m_workspace.volume()->geometry.toWorld(
        glm::dvec3(box.minimum + walk.placeOf(likely.middle)));
}

void Chunks::lookForLikely()
{
    // From half of the voxels, what is the segment's would look as if it were missing.
    if (m_leaves && !m_members.isCounting())
        m_likely.look(m_leaves, m_segment, m_members.own(), count());
}

void Chunks::setLook(const Look& look)
{
    Look wanted = look;
    wanted.count = std::clamp(look.count, fewest, most);
    wanted.opacity = std::clamp(look.opacity, 0.0f, 1.0f);
    if (wanted == m_look)
        return;
    const bool shows = wanted.shown != m_look.shown;
    const bool divides = wanted.count != m_look.count;
    if (divides)
        m_lit.clear();
    m_look = wanted;
    if (divides) {
        m_takesSuggestion = false; // the user has chosen
        if (m_members.isCounting())
            m_likely.forget(); // of another number of chunks
        lookForLikely();
    }
    if (shows) {
        // Who asks again has it tried again.
        if (core::SessionChunks* its = chunks(); its && m_look.shown)
            its->forgetFailure();
        follow();
    }
    colour();
    Q_EMIT lookChanged();
}

int Chunks::count() const
{
    const core::ChunkMap* chunks = map();
    return chunks
        ? std::clamp(m_look.count + m_specks, chunks->tree().fewest(), chunks->tree().finest())
        : 0;
}

int Chunks::ownCount() const
{
    if (!m_leaves)
        return 0;
    int own = 0;
    const core::ChunkTree& tree = m_leaves->map->tree();
    for (const Chunk chunk : tree.division(count()))
        own += has(chunk) && tree.voxels(chunk).size() >= speckVoxels ? 1 : 0;
    return own;
}

std::optional<Chunks::Chunk> Chunks::chunkAt(const glm::ivec3& voxel) const
{
    return m_leaves ? m_leaves->map->chunkAt(voxel, count()) : std::nullopt;
}

bool Chunks::has(Chunk chunk) const
{
    return chunk < m_has.size() && m_has[chunk];
}

std::int64_t Chunks::voxels(Chunk chunk) const
{
    return m_leaves ? std::int64_t(m_leaves->map->tree().voxels(chunk).size()) : 0;
}

void Chunks::setLit(std::vector<Chunk> chunks)
{
    if (chunks == m_lit)
        return;
    m_lit = std::move(chunks);
    colour();
}

void Chunks::countOwn()
{
    if (m_count != count()) {
        m_count = count();
        m_chunkOfLeaf = m_leaves->map->tree().chunksOfLeaves(m_count);
        m_colourOfLeaf = m_leaves->colours.of(m_leaves->map->tree(), m_count);
    }
    const std::vector<std::uint32_t>& own = m_members.own();
    std::vector<std::int64_t> lead; // by chunk, twice its own voxels less all
    for (std::size_t leaf = 0; leaf < m_chunkOfLeaf.size(); ++leaf) {
        const Chunk chunk = m_chunkOfLeaf[leaf];
        lead.resize(std::max(lead.size(), std::size_t(chunk) + 1));
        lead[chunk] +=
            2 * std::int64_t(own.empty() ? 0 : own[leaf]) - std::int64_t(m_leaves->voxels[leaf]);
    }
    m_has.assign(lead.size(), false);
    for (std::size_t chunk = 0; chunk < lead.size(); ++chunk)
        m_has[chunk] = lead[chunk] > 0;
}

bool Chunks::isHidden(int likelihood) const
{
    return m_look.bodies == Bodies::Own || (m_look.bodies == Bodies::Alike && likelihood >= 0);
}

std::vector<std::uint32_t> Chunks::argbOfLeaves(bool bodies) const
{
    const core::ChunkTree& tree = m_leaves->map->tree();
    const auto isLikely = [this](Chunk chunk) {
        const std::vector<Likely>& all = m_likely.all();
        return std::any_of(all.begin(), all.end(),
            [chunk](const Likely& likely) { return likely.chunk == chunk; });
    };
    std::vector<std::uint32_t> argb(m_chunkOfLeaf.size());
    for (std::size_t leaf = 0; leaf < argb.size(); ++leaf) {
        const Chunk chunk = m_chunkOfLeaf[leaf];
        const bool isOwn = m_has[chunk];
        const bool isLit = std::find(m_lit.begin(), m_lit.end(), chunk) != m_lit.end();
        const bool isUnseen =
            bodies && !isOwn && !isLit && !isLikely(chunk) && isHidden(tree.likelihood(chunk));
        argb[leaf] = argbOf(
            {.colour = m_colourOfLeaf[leaf], .isOwn = isOwn, .isLit = isLit, .isHidden = isUnseen});
    }
    return argb;
}

/// Empty: none has one.
std::vector<std::uint32_t> Chunks::rimsOfLeaves() const
{
    std::vector<std::uint32_t> rims;
    for (std::size_t i = 0; i < m_likely.all().size(); ++i) {
        const Likely& likely = m_likely.all()[i];
        rims.resize(m_chunkOfLeaf.size(), 0);
        // A line is drawn where colours differ, so two that touch must not have the same.
        const std::uint32_t rim = (likely.isInside ? takeRim : addRim) + std::uint32_t(i);
        for (std::size_t leaf = 0; leaf < rims.size(); ++leaf) {
            if (m_chunkOfLeaf[leaf] == likely.chunk)
                rims[leaf] = rim;
        }
    }
    return rims;
}

std::shared_ptr<const gpu::SceneChunks> Chunks::scene(
    std::vector<std::uint32_t> argb, const std::vector<std::uint32_t>& rims) const
{
    auto chunks = std::make_shared<gpu::SceneChunks>();
    chunks->box = m_leaves->map->box();
    chunks->leaves = m_leaves->ofVoxel;
    chunks->argb = std::move(argb);
    chunks->rims = rims;
    chunks->opacity = m_look.opacity;
    return chunks;
}

void Chunks::colour()
{
    // Whose a chunk is decides how it is drawn, so the coarse ones stay until that is counted.
    if (m_coarse && m_look.shown && (!m_leaves || m_members.isCounting())) {
        if (m_leaves)
            countOwn();
        CoarseLook look{.segment = m_segment, .count = m_look.count, .opacity = m_look.opacity};
        m_areas = coarseScene(*m_coarse, look);
        look.isHidden = [this](int likelihood) { return isHidden(likelihood); };
        m_bodies = coarseScene(*m_coarse, look);
        return Q_EMIT pictureChanged();
    }
    if (!m_leaves || !m_look.shown) {
        if (m_areas || m_bodies) {
            m_areas.reset();
            m_bodies.reset();
            Q_EMIT pictureChanged();
        }
        return;
    }
    countOwn();
    const std::vector<std::uint32_t> rims = rimsOfLeaves();
    const auto same = [&](const std::shared_ptr<const gpu::SceneChunks>& shown,
                          const std::vector<std::uint32_t>& argb) {
        return shown && shown->leaves == m_leaves->ofVoxel && shown->argb == argb
            && shown->rims == rims && shown->opacity == m_look.opacity;
    };
    std::vector<std::uint32_t> areas = argbOfLeaves(false);
    std::vector<std::uint32_t> bodies = argbOfLeaves(true);
    const bool sameAreas = same(m_areas, areas);
    const bool sameBodies = same(m_bodies, bodies);
    if (!sameAreas)
        m_areas = scene(std::move(areas), rims);
    if (!sameBodies)
        m_bodies = scene(std::move(bodies), rims);
    if (!sameAreas || !sameBodies)
        Q_EMIT pictureChanged();
}

void Chunks::divide(double marginMm, const QString& probabilityFile)
{
    core::EditSession* session = m_workspace.session();
    const core::Segment* segment =
        session ? session->document().segment(m_workspace.activeSegment()) : nullptr;
    if (!segment)
        return m_workspace.say(tr("No segment is chosen: choose the one to divide in the list"));
    if (segment->voxels == 0)
        return m_workspace.say(
            tr("%1 has no voxels yet: grow, paint or import it, then divide what lies around it")
                .arg(segment->name));
    const core::DivideSegment division{.segment = segment->label, .marginMm = marginMm};
    if (probabilityFile.isEmpty())
        return apply(division);
    core::DivideSegment asked = division;
    asked.probabilityFile = probabilityFile;
    m_workspace.say(tr("%1 is being read …").arg(QFileInfo(probabilityFile).fileName()));
    m_reading.replace(
        this,
        [asked, name = segment->name, volume = *m_workspace.volume()](
            const core::Progress& progress) {
            return core::readProbabilities(asked, name, volume, progress);
        },
        [this](const core::Result<core::ReadProbabilities>& read) {
            Q_EMIT changed(); // nothing is being read any more
            if (!read)
                return m_workspace.fail(read.error());
            apply(read->edit);
            QStringList notes;
            for (const core::MaskNote& note : read->notes)
                notes += maskNoteText(note);
            if (!notes.isEmpty())
                m_workspace.say(notes.join(u' '));
        });
    Q_EMIT changed();
}

void Chunks::apply(const core::DivideSegment& division)
{
    core::EditSession* session = m_workspace.session();
    m_dividedAfter = core::RowId(session->history().rows().size());
    if (const auto applied = session->apply(division); !applied)
        return m_workspace.fail(applied.error());
    if (const core::Segment* segment = session->document().segment(division.segment))
        m_workspace.say(tr("%1 and what lies around it is being divided …").arg(segment->name));
    m_takesSuggestion = m_isAwaited = true;
    Look look = m_look;
    look.shown = true;
    setLook(look);
}

void Chunks::abort()
{
    if (!isWorking())
        return;
    if (core::SessionChunks* its = chunks())
        its->cancel();
    takeBack();
}

/// Nothing is shown any more, and a division that led to nothing is undone. It stays if something
/// else was done after it, or is being done, which undo would take back in its place.
void Chunks::takeBack()
{
    m_takesSuggestion = m_isAwaited = false;
    Look look = m_look;
    look.shown = false;
    setLook(look);
    core::EditSession* session = m_workspace.session();
    if (!isJustDivided())
        return;
    const core::RowId row = session->history().position();
    const bool isStrokeOpen = session->transactionOpen() && !session->openIsPreview();
    if (isStrokeOpen || !session->history().row(row).edit.is<core::DivideSegment>())
        return sayThatItStays();
    session->closeOpen();
    if (session->idle())
        return undo();
    // What waits to be carried out, or ends, may become the step that undo takes back.
    session->questions().afterAll([this, session, row] {
        if (m_workspace.session() != session)
            return;
        if (session->idle() && session->history().position() == row)
            undo();
        else if (isJustDivided())
            sayThatItStays();
    });
}

void Chunks::sayThatItStays()
{
    m_workspace.say(tr("The division stays as a step of the history, since something else "
                       "was begun after it"));
}

void Chunks::undo()
{
    if (const auto undone = m_workspace.session()->undo(); !undone)
        m_workspace.fail(undone.error());
}

} // namespace ui
