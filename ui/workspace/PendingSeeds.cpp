// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/PendingSeeds.h"

#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <span>
#include <utility>

namespace ui {

struct PendingSeeds::Sketched {
    std::vector<gpu::SceneSeed> pending;
    std::vector<gpu::SceneSeed> grown; ///< growths have come to them
};

namespace {

glm::ivec3 voxelAt(const glm::dvec3& lps, const core::VolumeGeometry& geometry)
{
    return glm::ivec3(glm::floor(geometry.toIndex(lps) + 0.5));
}

} // namespace

PendingSeeds::PendingSeeds(Workspace& workspace)
    : QObject(&workspace)
    , m_workspace(workspace)
    , m_seeds(std::make_shared<const std::vector<gpu::SceneSeed>>())
{
    connect(&workspace, &Workspace::sessionChanged, this, &PendingSeeds::update);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History
                || change.what == core::DocumentChange::What::Segments)
                update();
        });
}

PendingSeeds::Sketched PendingSeeds::seedsOf(const core::EditSession& session)
{
    std::vector<gpu::SceneSeed> seeds;
    std::vector<std::pair<std::uint32_t, gpu::SceneSeed>> grown; ///< and since which generation
    std::uint32_t generation = 0;
    const core::History& history = session.history();
    const core::VolumeGeometry& geometry = session.document().volumes.front().geometry;
    for (const core::RowId id : history.standing()) {
        const core::HistoryRow& row = history.row(id);
        if (row.edit.is<core::GrowSteps>() || row.edit.is<core::ChangeInterval>()) {
            for (const gpu::SceneSeed& seed : seeds)
                grown.emplace_back(generation + 1, seed);
            seeds.clear();
        } else if (const auto* shrink = row.edit.as<core::ShrinkSteps>()) {
            // By steps it sends back those that came later; to the seeds it keeps all.
            if (shrink->steps && std::uint32_t(*shrink->steps) < generation) {
                const auto goes = [&row](const auto& each) {
                    return each.first > row.growthGeneration;
                };
                for (const auto& each : grown) {
                    if (goes(each))
                        seeds.push_back(each.second);
                }
                std::erase_if(grown, goes);
            }
        } else if (const auto* stroke = row.edit.as<core::SeedStroke>()) {
            // A seed that a growth came to and left waiting can be taken away too; one that it
            // accepted stays, and is asked after below.
            const auto taken = [stroke, &geometry](const gpu::SceneSeed& seed) {
                return seed.label == stroke->segment && stroke->takenLps
                    && std::any_of(stroke->takenLps->begin(), stroke->takenLps->end(),
                        [&](const glm::dvec3& place) {
                            return voxelAt(place, geometry) == voxelAt(seed.lps, geometry);
                        });
            };
            std::erase_if(seeds, taken);
            std::erase_if(grown, [&taken](const auto& each) { return taken(each.second); });
            for (const glm::dvec3& point : stroke->pointsLps)
                seeds.push_back({point, std::uint8_t(stroke->segment)});
        } else if (const auto* removed = row.edit.as<core::RemoveSegment>()) {
            std::erase_if(
                seeds, [removed](const auto& seed) { return seed.label == removed->segment; });
            std::erase_if(grown,
                [removed](const auto& each) { return each.second.label == removed->segment; });
        }
        generation = row.growthGeneration;
    }
    Sketched sketched{.pending = std::move(seeds), .grown = {}};
    for (const auto& each : grown)
        sketched.grown.push_back(each.second);
    for (std::vector<gpu::SceneSeed>* list : {&sketched.pending, &sketched.grown}) {
        std::erase_if(*list, [&session](const gpu::SceneSeed& seed) {
            const core::Segment* segment = session.document().segment(seed.label);
            return !segment || !segment->visible;
        });
    }
    return sketched;
}

void PendingSeeds::update()
{
    const core::EditSession* session = m_workspace.session();
    show(session ? seedsOf(*session) : Sketched());
}

// What the history tells is not all: what growths hold, barriers and seeds of others take no seed.
void PendingSeeds::show(Sketched sketched)
{
    const std::uint64_t asked = ++m_asked;
    if (sketched.pending.empty() && sketched.grown.empty()) {
        set({}, {});
        return;
    }
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    std::vector<glm::ivec3> voxels;
    for (const auto* list : {&sketched.pending, &sketched.grown}) {
        for (const gpu::SceneSeed& seed : *list)
            voxels.push_back(voxelAt(seed.lps, geometry));
    }
    m_workspace.session()->questions().probe(std::move(voxels),
        [seeds = QPointer<PendingSeeds>(this), asked, sketched = std::move(sketched)](
            const core::Result<std::vector<core::ProbedVoxel>>& probed) {
            const std::size_t pending = sketched.pending.size();
            if (!seeds || seeds->m_asked != asked || !probed
                || probed->size() != pending + sketched.grown.size())
                return;
            const auto waitingOf = [](const std::vector<gpu::SceneSeed>& list,
                                       std::span<const core::ProbedVoxel> probes) {
                std::vector<gpu::SceneSeed> waiting;
                for (std::size_t i = 0; i < list.size(); ++i) {
                    if (probes[i].seedOf == list[i].label)
                        waiting.push_back(list[i]);
                }
                return waiting;
            };
            const std::span<const core::ProbedVoxel> probes(*probed);
            seeds->set(waitingOf(sketched.pending, probes.first(pending)),
                waitingOf(sketched.grown, probes.subspan(pending)));
        });
}

void PendingSeeds::set(std::vector<gpu::SceneSeed> pending, std::vector<gpu::SceneSeed> hollow)
{
    if (pending == *m_seeds && hollow == m_hollow)
        return;
    if (pending != *m_seeds)
        m_seeds = std::make_shared<const std::vector<gpu::SceneSeed>>(std::move(pending));
    m_hollow = std::move(hollow);
    Q_EMIT changed();
}

} // namespace ui
