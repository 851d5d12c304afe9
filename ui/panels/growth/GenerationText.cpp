// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/GenerationText.h"

#include "core/edits/kinds/GrowthKinds.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/history/MovedGrowth.h"
#include "core/session/EditSession.h"
#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"

#include <QObject>

#include <optional>

namespace ui {

namespace {

// What a step of a growth did, or none: of these only the generation is told.

std::optional<QString> whatItDid(const core::GrowSteps&)
{
    return QObject::tr("Generation %1 · added %2");
}

template <class E>
requires core::isOneOf<E, core::ShrinkSteps, core::ShrinkAt, core::PlugLeak> std::optional<QString>
whatItDid(const E&)
{
    return QObject::tr("Generation %1 · taken back %2");
}

std::optional<QString> whatItDid(const core::ChangeInterval&)
{
    return QObject::tr("Generation %1 · changed by %2");
}

template <class E>
requires core::isOneOf<E, core::SeedStroke, core::BarrierStroke, core::ResumeGrowth,
    core::GrowFromSeeds>
    std::optional<QString> whatItDid(const E&)
{
    return std::nullopt;
}

} // namespace

QString generationText(
    std::uint32_t generation, const core::HistoryRow* row, const core::Volume& volume)
{
    QString text = QObject::tr("Generation %1").arg(countText(generation));
    const auto tell = [&](const auto& known) {
        if (const std::optional<QString> did = whatItDid(known))
            text = did->arg(
                countText(generation), millilitreText(volume, row->statistics.voxelsChanged));
    };
    if (row)
        core::visitAmong(tell, row->edit, core::GrowthKinds());
    return text;
}

QString generationText(
    const core::EditSession& session, std::uint8_t plane, const std::vector<std::uint32_t>& fronts)
{
    const core::GrowthProgress progress = session.growthProgress();
    const core::Document& document = session.document();
    const core::Volume& volume = document.volumes.front();
    if (progress.open && progress.members > 0)
        return QObject::tr("Generation %1 · front %2 · +%3")
            .arg(countText(progress.generation),
                countText(fronts.empty() ? 0 : qlonglong(fronts.back())),
                millilitreText(volume, progress.members));
    const std::uint32_t generation =
        progress.open ? progress.generation : document.generation(plane);
    const core::History& history = session.history();
    const core::HistoryRow* row =
        progress.open || history.position() == 0 ? nullptr : &history.row(history.position());
    if (row && core::recordedGrowthPlane(row->edit, history) != plane)
        row = nullptr; // it was done to another growth
    return generationText(generation, row, volume);
}

} // namespace ui
