// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/GenerationSection.h"

#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/panels/growth/GenerationBar.h"
#include "ui/tasks/growth/GrowthTurns.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int countAfterMilliseconds = 120;

} // namespace

GenerationSection::GenerationSection(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_bar(new GenerationBar(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_bar);
    using ToText = QString (*)(const core::Volume& volume, std::int64_t voxels);
    const auto inVolume = [this](ToText text) {
        return [this, text](std::int64_t voxels) {
            const core::Volume* volume = m_workspace.volume();
            return volume ? text(*volume, voxels) : QString();
        };
    };
    m_bar->setSizeTexts(inVolume(millilitreText), inVolume(countedText));
    m_countLater.setSingleShot(true);
    m_countLater.setInterval(countAfterMilliseconds);
    connect(&m_countLater, &QTimer::timeout, this, &GenerationSection::count);
    connect(m_bar, &GenerationBar::scrubBegan, this, &GenerationSection::begin);
    connect(m_bar, &GenerationBar::scrubbed, this, &GenerationSection::goTo);
    connect(m_bar, &GenerationBar::scrubEnded, this, &GenerationSection::end);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_plane = m_workspace.growthPlane();
        m_sizes.clear();
        m_added.clear();
        showSizes();
        m_countLater.start();
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            using What = core::DocumentChange::What;
            if (change.what == What::Growth || change.what == What::History)
                m_countLater.start();
            if (change.what == What::Segments)
                showScrubbable(); // one may have been locked
        });
    connect(&workspace, &Workspace::sessionSaved, this, &GenerationSection::showScrubbable);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &GenerationSection::followPlane);
    m_countLater.start();
}

/// What is counted in one plane says nothing of another. While the bar is dragged it stays.
void GenerationSection::followPlane()
{
    if (m_bar->scrubbing() || m_plane == m_workspace.growthPlane())
        return;
    m_plane = m_workspace.growthPlane();
    m_sizes.clear();
    m_added.clear();
    showSizes();
    m_countLater.start();
}

void GenerationSection::show(const core::GrowthProgress& progress)
{
    // After the end its generations are in the words, but not counted yet.
    if (!progress.open || progress.frontSizes == m_added)
        return;
    m_added = progress.frontSizes;
    showSizes();
}

void GenerationSection::showLeak(const std::optional<core::LeakAlarm>& alarm)
{
    std::optional<std::pair<int, int>> generations;
    if (alarm)
        generations = {int(alarm->narrow), int(alarm->generation)};
    m_bar->setLeak(generations);
}

QString GenerationSection::scrubText() const
{
    return m_bar->scrubText();
}

void GenerationSection::count()
{
    core::EditSession* session = m_workspace.session();
    if (!session || m_bar->scrubbing() || session->growthProgress().open)
        return;
    const std::uint8_t plane = m_plane;
    session->questions().generationSizes(plane,
        [section = QPointer<GenerationSection>(this), plane](
            core::Result<std::vector<std::uint32_t>> sizes) {
            if (!section || !sizes || section->m_bar->scrubbing() || plane != section->m_plane)
                return;
            section->m_sizes = *std::move(sizes);
            if (!section->m_sizes.empty())
                section->m_sizes.erase(section->m_sizes.begin()); // what was painted is no step
            section->m_added.clear();
            section->showSizes();
        });
}

void GenerationSection::showSizes()
{
    std::vector<std::uint32_t> sizes = m_sizes;
    sizes.insert(sizes.end(), m_added.begin(), m_added.end());
    m_bar->setSizes(sizes);
    showScrubbable();
}

void GenerationSection::showScrubbable()
{
    const core::EditSession* session = m_workspace.session();
    m_bar->setScrubbable(session && m_added.empty() && m_sizes.size() > 1
        && session->whyReadOnly().isEmpty() && !everySegmentLocked(session->document(), m_plane));
}

void GenerationSection::begin()
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    if (const auto begun =
            session->begin(core::ShrinkSteps{.steps = 0, .plane = core::namedPlane(m_plane)});
        !begun) {
        m_bar->abandon();
        m_workspace.fail(begun.error());
    }
}

void GenerationSection::goTo(int generation)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const auto last = int(session->document().generation(m_plane));
    // The first generation is that of the accepted seeds: all steps lead there.
    const int steps = generation <= 1 ? last : last - generation;
    session->extend(core::ToSteps{std::max(steps, 0)});
    Q_EMIT scrubMoved();
}

void GenerationSection::end(bool kept)
{
    // What is open may be another's by now: the preview of a dialog, a growth, a stroke.
    if (core::EditSession* session = m_workspace.session();
        session && session->isOpen<core::ShrinkSteps>())
        session->end(kept ? core::Ending::Commit : core::Ending::Rollback);
    followPlane();
    m_countLater.start();
    Q_EMIT scrubMoved();
}

} // namespace ui
