// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/ShrinkTool.h"

#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/RowTitleText.h"
#include "ui/base/Theme.h"
#include "ui/tools/growth/HeldShrink.h"
#include "ui/tools/growth/ShrinkPreview.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>
#include <QToolButton>

namespace ui {

namespace {

constexpr int restMilliseconds = 700;
/// A hand that holds still moves the pen by so many pixels.
constexpr double stillPixels = 4.0;

} // namespace

ShrinkTool::ShrinkTool(Workspace& workspace, QObject* parent)
    : SketchTool(workspace, parent)
    , m_sketched(new SketchedVoxels(workspace, this))
    , m_preview(new ShrinkPreview(workspace, this))
    , m_held(new HeldShrink(workspace, this))
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &ShrinkTool::rest);
    connect(m_sketched, &SketchedVoxels::grew, this,
        [this] { m_preview->follow(m_sketched->voxels()); });
    connect(m_preview, &ShrinkPreview::changed, this, [this] {
        if (m_rest.isActive() || m_preview->upToDate())
            m_rest.start(); // it is read first
        Q_EMIT overlayChanged();
    });
    connect(m_held, &HeldShrink::changed, this, &Tool::overlayChanged);
}

QString ShrinkTool::name() const
{
    return tr("Shrink");
}

QString ShrinkTool::iconName() const
{
    return QStringLiteral("shrink-here");
}

QString ShrinkTool::hint() const
{
    return tr("Shrink: sketch over what grew too far; it goes, up to its narrowest passage, which "
              "is shut; hold the pen still to go back generation by generation; what is nearer to "
              "the seeds stays");
}

QString ShrinkTool::target() const
{
    return tr("takes back what grew through here");
}

QString ShrinkTool::keys() const
{
    return tr("Hold still: generation by generation · Ctrl: only the sketched voxels · %1")
        .arg(SketchTool::keys());
}

QWidget* ShrinkTool::createOptions(QWidget* parent)
{
    return widthButton(parent);
}

void ShrinkTool::sketchBegan(const ViewContext& view)
{
    // The preview is said of a growth that stands; the edit would end it anyway.
    workspace().session()->closeOpen();
    m_preview->begin(isInverse());
    m_sketched->begin(view);
    m_restsAt.reset();
}

void ShrinkTool::sketchGrew(const SketchPath& path)
{
    if (m_held->on())
        return; // it began with the sketch as it was
    m_sketched->follow(path);
    if (m_restsAt && glm::distance(*m_restsAt, path.points.back()) < stillPixels)
        return;
    m_restsAt = path.points.back();
    m_rest.start();
}

bool ShrinkTool::previewIsWhole() const
{
    return m_sketched->isComplete() && m_preview->upToDate();
}

/// The pen rests: unless it takes nothing at all, it goes back from here.
void ShrinkTool::rest()
{
    const bool takes = m_preview->upToDate() && m_preview->voxels().value_or(0) > 0;
    if (!drawing() || isInverse() || !takes)
        return; // a foresight that is late begins the rest anew
    if (!m_sketched->isComplete())
        return m_rest.start();
    const std::vector<glm::ivec3> voxels = m_sketched->voxels();
    m_preview->end();
    m_rest.stop();
    (void)m_held->begin(voxels);
}

bool ShrinkTool::finishOtherwise(const std::vector<glm::dvec2>&, const ViewContext&)
{
    if (!m_held->on())
        return false;
    if (m_held->refused()) {
        // Going back would take everything; cutting it off at its narrowest place may not.
        m_held->end(false);
        return false;
    }
    const std::size_t rows = workspace().session()->history().rows().size();
    m_held->end(true);
    reportLastRow(rows);
    return true;
}

void ShrinkTool::sketchOver()
{
    m_held->end(false); // unless it has been kept
    m_sketched->end();
    m_preview->end();
    m_rest.stop();
}

QStringList ShrinkTool::cursorLines() const
{
    if (m_held->on())
        return {m_held->words()};
    const QString cutPreview = m_preview->words();
    return cutPreview.isEmpty() ? SketchTool::cursorLines() : QStringList{cutPreview};
}

void ShrinkTool::commit(const std::vector<glm::ivec3>& voxels)
{
    core::ShrinkAt shrink{.plane = core::namedPlane(growthPlane())};
    for (const glm::ivec3& voxel : voxels)
        shrink.pointsLps.push_back(workspace().volume()->geometry.toWorld(glm::dvec3(voxel)));
    shrink.onlyHere = isInverse();
    core::EditSession& session = *workspace().session();
    const std::size_t rows = session.history().rows().size();
    if (const auto applied = session.apply(shrink); !applied) {
        workspace().fail(applied.error());
        return;
    }
    reportLastRow(rows);
}

/// Tells the user what the edit has done that was asked for last.
void ShrinkTool::reportLastRow(std::size_t rows)
{
    // Answered when the edit is carried out.
    workspace().session()->questions().afterAll([tool = QPointer<ShrinkTool>(this), rows] {
        if (!tool)
            return;
        // What was refused has been told already.
        const core::History& history = tool->workspace().session()->history();
        if (history.rows().size() > rows)
            tool->workspace().say(nameOf(history.rows().back()));
    });
}

QColor ShrinkTool::colour() const
{
    return theme::caution;
}

QString ShrinkTool::outsideText() const
{
    return tr("Nothing was taken back: the sketch lies outside the volume");
}

QString ShrinkTool::nothingSeenText() const
{
    return tr("Nothing was taken back: nothing is seen under the sketch");
}

} // namespace ui
