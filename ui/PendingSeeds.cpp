// SPDX-License-Identifier: Apache-2.0
#include "ui/PendingSeeds.h"

#include "ui/Workspace.h"

#include <utility>

namespace ui {

namespace {

std::vector<gpu::SceneSeed> pendingSeeds(const core::EditSession& session)
{
    std::vector<gpu::SceneSeed> seeds;
    std::vector<std::pair<std::uint32_t, gpu::SceneSeed>> grown; ///< and since which generation
    std::uint32_t generation = 0;
    const core::History& history = session.history();
    for (const core::RowId id : history.standing()) {
        const core::HistoryRow& row = history.row(id);
        if (std::holds_alternative<core::GrowSteps>(row.edit)) {
            for (const gpu::SceneSeed& seed : seeds)
                grown.emplace_back(generation + 1, seed);
            seeds.clear();
        } else if (const auto* shrink = std::get_if<core::ShrinkSteps>(&row.edit)) {
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
        } else if (const auto* stroke = std::get_if<core::SeedStroke>(&row.edit)) {
            for (const glm::dvec3& point : stroke->pointsLps)
                seeds.push_back({point, std::uint8_t(stroke->segment)});
        } else if (const auto* removed = std::get_if<core::RemoveSegment>(&row.edit)) {
            std::erase_if(
                seeds, [removed](const auto& seed) { return seed.label == removed->segment; });
            std::erase_if(grown,
                [removed](const auto& each) { return each.second.label == removed->segment; });
        }
        generation = row.growthGeneration;
    }
    std::erase_if(seeds, [&session](const gpu::SceneSeed& seed) {
        const core::Segment* segment = session.document().segment(seed.label);
        return !segment || !segment->visible;
    });
    return seeds;
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

void PendingSeeds::update()
{
    const core::EditSession* session = m_workspace.session();
    std::vector<gpu::SceneSeed> seeds =
        session ? pendingSeeds(*session) : std::vector<gpu::SceneSeed>();
    if (seeds == *m_seeds)
        return;
    m_seeds = std::make_shared<const std::vector<gpu::SceneSeed>>(std::move(seeds));
    Q_EMIT changed();
}

} // namespace ui
