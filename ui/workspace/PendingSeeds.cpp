// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/PendingSeeds.h"

#include "core/edits/kinds/GrowthKinds.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/history/MovedGrowth.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <utility>

namespace ui {

struct PendingSeeds::Sketched {
    std::vector<gpu::SceneSeed> pending;
    std::vector<gpu::SceneSeed> grown; ///< growths have come to them
};

namespace {

/// A seed that the engine is asked about.
struct Asked {
    gpu::SceneSeed seed;
    bool isGrown = false; ///< a growth has come to it
};

glm::ivec3 voxelAt(const glm::dvec3& lps, const core::VolumeGeometry& geometry)
{
    return glm::ivec3(glm::floor(geometry.toIndex(lps) + 0.5));
}

/// Where sketched seeds are after each row of a history, from the first on: those that no growth
/// has come to, and those that one has.
class SeedsAlong {
public:
    explicit SeedsAlong(const core::Document& document)
        : m_document(document)
        , m_geometry(document.volumes.front().geometry)
    {
    }

    /// @param history of the row
    void follow(const core::HistoryRow& row, const core::History& history)
    {
        core::visitAmong([&](const auto& known) { take(known, row.growthGeneration); }, row.edit,
            core::GrowthKinds());
        if (const auto* removed = row.edit.as<core::RemoveSegment>())
            forget([&](const gpu::SceneSeed& seed) { return seed.label == removed->segment; });
        m_generations[core::recordedGrowthPlane(row.edit, history)] = row.growthGeneration;
    }
    [[nodiscard]] std::vector<gpu::SceneSeed> pending() const { return m_pending; }
    [[nodiscard]] std::vector<gpu::SceneSeed> grown() const
    {
        std::vector<gpu::SceneSeed> seeds;
        for (const Grown& each : m_grown)
            seeds.push_back(each.seed);
        return seeds;
    }

private:
    struct Grown {
        std::uint32_t since = 0; ///< generation
        gpu::SceneSeed seed;
    };

    /// A seed that a growth came to and left waiting can be taken away too; one that it accepted
    /// stays, and is asked after (show()).
    void take(const core::SeedStroke& stroke, std::uint32_t)
    {
        forget([&](const gpu::SceneSeed& seed) {
            return seed.label == stroke.segment && stroke.takenLps
                && std::any_of(
                    stroke.takenLps->begin(), stroke.takenLps->end(), [&](const glm::dvec3& place) {
                        return voxelAt(place, m_geometry) == voxelAt(seed.lps, m_geometry);
                    });
        });
        for (const glm::dvec3& point : stroke.pointsLps)
            m_pending.push_back({point, std::uint8_t(stroke.segment)});
    }
    void take(const core::GrowSteps& grow, std::uint32_t) { comeTo(grow.criteria); }
    void take(const core::ChangeInterval& change, std::uint32_t) { comeTo(change.criteria); }
    /// By steps it sends back those that came later; to the seeds it keeps all.
    void take(const core::ShrinkSteps& shrink, std::uint32_t generation)
    {
        const std::uint8_t plane = core::growthPlaneOf(shrink.plane);
        if (!shrink.steps || std::uint32_t(*shrink.steps) >= m_generations[plane])
            return;
        const auto goes = [&](const Grown& each) {
            return each.since > generation && planeOf(each.seed) == plane;
        };
        for (const Grown& each : m_grown) {
            if (goes(each))
                m_pending.push_back(each.seed);
        }
        std::erase_if(m_grown, goes);
    }
    /// Where these leave a seed, the engine knows (show()). ResumeGrowth stands in no row.
    template <class E>
    requires core::isOneOf<E, core::BarrierStroke, core::ResumeGrowth, core::ShrinkAt,
        core::PlugLeak, core::GrowFromSeeds>
    void take(const E&, std::uint32_t) { }

    void comeTo(const core::GrowCriteria& criteria)
    {
        const std::uint8_t plane = core::growthPlaneOf(criteria.plane);
        const auto& segments = criteria.segments;
        const auto rests =
            std::stable_partition(m_pending.begin(), m_pending.end(), [&](const auto& seed) {
                return planeOf(seed) == plane
                    && (!segments
                        || std::find(segments->begin(), segments->end(), int(seed.label))
                            != segments->end());
            });
        for (auto seed = m_pending.begin(); seed != rests; ++seed)
            m_grown.push_back({.since = m_generations[plane] + 1, .seed = *seed});
        m_pending.erase(m_pending.begin(), rests);
    }
    /// Of a segment that is gone, whose seeds are not shown: any.
    [[nodiscard]] std::uint8_t planeOf(const gpu::SceneSeed& seed) const
    {
        const core::Segment* segment = m_document.segment(seed.label);
        return segment ? segment->plane : std::uint8_t(0);
    }
    template <class Which> void forget(const Which& which)
    {
        std::erase_if(m_pending, which);
        std::erase_if(m_grown, [&](const Grown& each) { return which(each.seed); });
    }

    const core::Document& m_document;
    const core::VolumeGeometry& m_geometry;
    std::vector<gpu::SceneSeed> m_pending;
    std::vector<Grown> m_grown;
    std::map<std::uint8_t, std::uint32_t> m_generations; ///< by label plane
};

} // namespace

PendingSeeds::PendingSeeds(Workspace& workspace)
    : QObject(&workspace)
    , m_workspace(workspace)
    , m_seeds(std::make_shared<const std::vector<gpu::SceneSeed>>())
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_seenAlong.clear();
        m_intervals.clear();
        m_past.clear();
        m_acceptedFronts.clear();
        update();
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History
                || change.what == core::DocumentChange::What::Segments)
                update();
        });
    connect(&workspace, &Workspace::growSettingsChanged, this,
        [this] { m_acceptedFronts.follow(m_workspace.growSettings()); });
}

PendingSeeds::Sketched PendingSeeds::seedsOf(const core::EditSession& session)
{
    const core::History& history = session.history();
    SeedsAlong seeds(session.document());
    for (const core::RowId id : history.standing())
        seeds.follow(history.row(id), history);
    Sketched sketched{.pending = seeds.pending(), .grown = seeds.grown()};
    for (std::vector<gpu::SceneSeed>* list : {&sketched.pending, &sketched.grown}) {
        std::erase_if(*list, [&session](const gpu::SceneSeed& seed) {
            const core::Segment* segment = session.document().segment(seed.label);
            return !segment || !segment->visible;
        });
    }
    return sketched;
}

void PendingSeeds::noteSketch(int label, const std::vector<glm::ivec3>& voxels,
    const std::vector<std::pair<glm::ivec3, glm::dvec3>>& seenAlong)
{
    for (const glm::ivec3& voxel : voxels)
        m_seenAlong.erase({label, voxel.x, voxel.y, voxel.z});
    for (const auto& [voxel, direction] : seenAlong)
        m_seenAlong.try_emplace({label, voxel.x, voxel.y, voxel.z}, direction);
}

std::optional<glm::dvec3> PendingSeeds::seenAlong(int label, const glm::ivec3& voxel) const
{
    const auto found = m_seenAlong.find({label, voxel.x, voxel.y, voxel.z});
    return found == m_seenAlong.end() ? std::nullopt : std::optional(found->second);
}

void PendingSeeds::setGhost(const Ghost& ghost)
{
    if (ghost == m_ghost)
        return;
    m_ghost = ghost;
    Q_EMIT ghostChanged();
}

void PendingSeeds::update()
{
    const core::EditSession* session = m_workspace.session();
    if (session) {
        m_intervals.follow(*session);
        m_acceptedFronts.follow(*session);
    }
    show(session ? seedsOf(*session) : Sketched());
}

// What the history tells is not all: what growths hold, barriers and seeds of others take no seed.
void PendingSeeds::show(Sketched sketched)
{
    const std::uint64_t asked = ++m_asked;
    m_isAsking = true;
    if (sketched.pending.empty() && sketched.grown.empty()) {
        set({}, {});
        return;
    }
    // One question for each label plane in which there are any; the last answer shows them.
    const core::Document& document = m_workspace.session()->document();
    std::map<std::uint8_t, std::vector<Asked>> byPlane;
    for (const bool isGrown : {false, true}) {
        for (const gpu::SceneSeed& seed : isGrown ? sketched.grown : sketched.pending)
            byPlane[document.segment(seed.label)->plane].push_back({seed, isGrown});
    }
    const auto waiting = std::make_shared<Sketched>();
    for (const auto& [plane, list] : byPlane) {
        std::vector<glm::ivec3> voxels;
        for (const Asked& each : list)
            voxels.push_back(voxelAt(each.seed.lps, document.volumes.front().geometry));
        const bool isLast = plane == byPlane.rbegin()->first;
        m_workspace.session()->questions().probe(
            std::move(voxels),
            [seeds = QPointer<PendingSeeds>(this), asked, waiting, list = list, isLast](
                const core::Result<std::vector<core::ProbedVoxel>>& probed) {
                if (!seeds || seeds->m_asked != asked || !probed || probed->size() != list.size())
                    return;
                for (std::size_t i = 0; i < list.size(); ++i) {
                    if ((*probed)[i].seedOf == list[i].seed.label)
                        (list[i].isGrown ? waiting->grown : waiting->pending)
                            .push_back(list[i].seed);
                }
                if (isLast)
                    seeds->set(std::move(waiting->pending), std::move(waiting->grown));
            },
            plane);
    }
}

void PendingSeeds::set(std::vector<gpu::SceneSeed> pending, std::vector<gpu::SceneSeed> hollow)
{
    m_isAsking = false;
    const bool differs = pending != *m_seeds || hollow != m_hollow;
    if (pending != *m_seeds)
        m_seeds = std::make_shared<const std::vector<gpu::SceneSeed>>(std::move(pending));
    m_hollow = std::move(hollow);
    if (differs)
        Q_EMIT changed();
    Q_EMIT updated();
}

} // namespace ui
