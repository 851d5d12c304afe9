// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/PeelTool.h"

#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/DisplayJson.h"
#include "ui/base/NumberText.h"
#include "ui/base/RowTitleText.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/sculpt/PeelOptions.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>
#include <QPointer>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

PeelTool::PeelTool(Workspace& workspace, QObject* parent)
    : OutlineTool(workspace, parent)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_wasPutAway = false;
        m_endedByOther = false;
        m_depthDrag.reset();
        if (!std::exchange(m_open, false))
            return;
        Q_EMIT changed();
        Q_EMIT overlayChanged();
    });
    connect(&workspace, &Workspace::failed, this, [this] { ++m_failures; });
    connect(&workspace, &Workspace::documentChanged, this, &PeelTool::follow);
    connect(&workspace, &Workspace::activeToolChanged, this, [this] { offerToTakeBack(); });
}

double PeelTool::usualJumpMm()
{
    return core::PeelCut().jumpMm;
}

QString PeelTool::name() const
{
    return tr("Peel");
}

QString PeelTool::iconName() const
{
    return QStringLiteral("peel");
}

QString PeelTool::hint() const
{
    return m_open ? tr("Peel: drag down for deeper, up for shallower; letting go or Enter keeps "
                       "it, Esc takes it back")
                  : tr("Peel: draw a curve on the 3D view; Ctrl or the eraser end restores");
}

QString PeelTool::keys() const
{
    return tr("Second drag, Ctrl+Shift+wheel or [ ] depth · Enter keeps · Esc takes back");
}

QWidget* PeelTool::createOptions(QWidget* parent)
{
    return new PeelOptions(*this, parent);
}

QJsonObject PeelTool::settingsJson() const
{
    return {{QStringLiteral("depthMm"), m_depthMm}, {QStringLiteral("throughGaps"), m_gaps.through},
        {QStringLiteral("jumpMm"), m_gaps.jumpMm}};
}

void PeelTool::applySettings(const QJsonObject& settings)
{
    double depthMm = m_depthMm;
    Gaps gaps = m_gaps;
    displayJson::read(settings[QLatin1String("depthMm")], depthMm);
    displayJson::read(settings[QLatin1String("throughGaps")], gaps.through);
    displayJson::read(settings[QLatin1String("jumpMm")], gaps.jumpMm, 0.0, maximumJumpMm);
    setDepthMm(depthMm);
    setGaps(gaps);
}

void PeelTool::setDepthMm(double depthMm)
{
    depthMm = std::clamp(depthMm, minimumDepthMm, maximumDepthMm);
    if (depthMm == m_depthMm)
        return;
    m_depthMm = depthMm;
    if (m_open)
        workspace().session()->extend(core::ToDepth{depthMm});
    Q_EMIT changed();
    Q_EMIT overlayChanged();
}

void PeelTool::changeDepth(int steps)
{
    const double step = m_depthMm < 10.0 ? 0.5 : 1.0;
    setDepthMm(std::round(m_depthMm / step + steps) * step);
}

void PeelTool::setGaps(const Gaps& gaps)
{
    if (gaps == m_gaps)
        return;
    m_gaps = gaps;
    if (m_open) {
        // Which surface is peeled is decided where a peel begins.
        if (workspace().session()->isOpen<core::PeelCut>())
            workspace().session()->end(core::Ending::Rollback);
        m_open = open(m_peel.get<core::PeelCut>());
    }
    Q_EMIT changed();
    Q_EMIT overlayChanged();
}

bool PeelTool::open(core::PeelCut peel)
{
    peel.depthMm = m_depthMm;
    peel.throughGaps = m_gaps.through;
    peel.jumpMm = m_gaps.jumpMm;
    m_peel = std::move(peel);
    m_endedByOther = false;
    m_rowsBefore = workspace().session()->history().rows().size();
    m_failuresBefore = m_failures;
    const auto begun = workspace().session()->begin(m_peel);
    if (!begun)
        workspace().fail(begun.error());
    return begun.has_value();
}

void PeelTool::cut(const Sketch& sketch)
{
    core::PeelCut peel;
    peel.layer = workspace().activeLayer();
    peel.view = sketch.view;
    peel.polygonMm = sketch.polygonMm;
    peel.surfaceThreshold = surfaceThreshold();
    peel.restore = sketch.restore;
    peel.hidden = sketch.hidden;
    m_open = open(peel);
    if (!m_open)
        return;
    workspace().say(hint());
    Q_EMIT changed();
}

void PeelTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_open)
        return OutlineTool::press(sample, view);
    if (m_depthDrag || !worksIn(view))
        return;
    m_depthDrag = DepthDrag{.from = sample.position,
        .fromMm = m_depthMm,
        .mmPerPixel = std::min(view.mmPerPixel(), mostMmPerPixel),
        .view = view.view};
    showCursor(sample.position, view.view);
}

void PeelTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_depthDrag)
        return OutlineTool::drag(sample, view);
    if (view.view != m_depthDrag->view)
        return;
    const double down = sample.position.y() - m_depthDrag->from.y();
    setDepthMm(std::round((m_depthDrag->fromMm + down * m_depthDrag->mmPerPixel) * 10.0) / 10.0);
    showCursor(sample.position, view.view);
}

void PeelTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_depthDrag)
        return OutlineTool::release(sample, view);
    drag(sample, view);
    m_depthDrag.reset();
    confirm();
}

void PeelTool::close(core::Ending ending)
{
    m_open = false;
    m_depthDrag.reset();
    core::EditSession* session = workspace().session();
    if (session && session->isOpen<core::PeelCut>())
        session->end(ending);
    Q_EMIT changed();
    Q_EMIT overlayChanged();
}

void PeelTool::confirm()
{
    if (!m_open)
        return;
    close(core::Ending::Commit);
    reportKept([this](const core::HistoryRow& row) {
        const bool restores = row.edit.get<core::PeelCut>().restore;
        workspace().say(
            restores ? nameOf(row) : tr("%1; Ctrl+L lifts it as a piece").arg(nameOf(row)));
    });
}

/// Over the air, and where nothing is left to restore, a peel becomes no row; that is known when it
/// is carried out.
void PeelTool::reportKept(const std::function<void(const core::HistoryRow&)>& report)
{
    const bool restores = m_peel.get<core::PeelCut>().restore;
    workspace().session()->questions().afterAll(
        [tool = QPointer<PeelTool>(this), before = m_rowsBefore, failures = m_failuresBefore,
            restores, report] {
            if (!tool)
                return;
            if (const core::RowId row = tool->keptRow(before); row != 0)
                report(tool->workspace().session()->history().row(row));
            else
                tool->sayNothingWasCut(failures, restores);
        });
}

/// A peel that was refused, or that failed, is no row either: then its error is what is said. It is
/// reported right after the answers that have come with it.
void PeelTool::sayNothingWasCut(int failures, bool restores)
{
    QTimer::singleShot(0, this, [this, failures, restores] {
        if (m_failures == failures)
            workspace().say(
                restores ? tr("Nothing was restored there") : tr("Nothing was peeled there"));
    });
}

/// The row of the peel is reported when it is seen; here it is reported if there is none.
void PeelTool::awaitEndByOther()
{
    m_endedByOther = true;
    const bool restores = m_peel.get<core::PeelCut>().restore;
    workspace().session()->questions().afterAll(
        [tool = QPointer<PeelTool>(this), before = m_rowsBefore, failures = m_failuresBefore,
            restores] {
            if (!tool || !tool->m_endedByOther || tool->keptRow(before) != 0)
                return;
            tool->m_endedByOther = false;
            tool->sayNothingWasCut(failures, restores);
        });
}

/// The peel is kept, and the user is told.
void PeelTool::putAway()
{
    OutlineTool::cancel();
    if (!m_open)
        return;
    close(core::Ending::Commit);
    reportKept([this](const core::HistoryRow& row) { workspace().say(keptText(row)); });
    // Another tool is there at once; an undo that did this needs no offer.
    m_wasPutAway = true;
    QTimer::singleShot(0, this, [this] { m_wasPutAway = false; });
}

void PeelTool::cancel()
{
    OutlineTool::cancel();
    if (!m_open)
        return;
    close(core::Ending::Rollback);
    workspace().say(tr("The peel was taken back"));
}

/// Another step may have closed the peel.
void PeelTool::follow()
{
    const core::EditSession* session = workspace().session();
    // What is open then may be another's: a growth begins in the moment that it ends a peel.
    if (m_open && !(session && session->isOpen<core::PeelCut>() && keptRow(m_rowsBefore) == 0)) {
        m_open = false;
        m_depthDrag.reset();
        if (session)
            awaitEndByOther();
        Q_EMIT changed();
        Q_EMIT overlayChanged();
    }
    if (!m_endedByOther)
        return;
    if (const core::RowId row = keptRow(m_rowsBefore); row != 0) {
        m_endedByOther = false;
        workspace().say(keptText(session->history().row(row)));
    }
}

core::RowId PeelTool::keptRow(std::size_t rowsBefore) const
{
    const core::EditSession* session = workspace().session();
    if (!session)
        return 0;
    const std::vector<core::HistoryRow>& rows = session->history().rows();
    // An earlier peel may have become a row since.
    for (std::size_t i = rows.size(); i > rowsBefore; --i) {
        if (rows[i - 1].edit.as<core::PeelCut>())
            return rows[i - 1].id;
    }
    return 0;
}

QString PeelTool::keptText(const core::HistoryRow& row)
{
    return tr("The open peel, %1 mm, was kept as a step")
        .arg(numberText(row.edit.get<core::PeelCut>().depthMm, 1));
}

void PeelTool::offerToTakeBack()
{
    if (!std::exchange(m_wasPutAway, false) || !workspace().session())
        return;
    workspace().session()->questions().afterAll(
        [tool = QPointer<PeelTool>(this), before = m_rowsBefore] {
            const core::RowId row = tool ? tool->keptRow(before) : 0;
            if (row != 0)
                tool->offerToTakeBack(row);
        });
}

void PeelTool::offerToTakeBack(core::RowId row)
{
    core::EditSession* kept = workspace().session();
    workspace().offer({.sentence = keptText(kept->history().row(row)),
        .button = tr("Take it back"),
        .run = [this, kept, row] {
            core::EditSession* session = workspace().session();
            if (!session || session != kept || session->history().position() != row) {
                workspace().say(tr("The history has gone on since; Ctrl+Z takes back its last "
                                   "step"));
            } else if (const auto undone = session->undo(); !undone) {
                workspace().fail(undone.error());
            }
        }});
}

SurfacePatch PeelTool::taken(SurfacePatch surface) const
{
    if (m_gaps.jumpMm > 0.0)
        surface.keepLargest(m_gaps.jumpMm);
    return surface;
}

QStringList PeelTool::lines() const
{
    const QString depth = tr("%1 mm thick").arg(numberText(m_depthMm, 1));
    if (m_depthDrag)
        return {depth, tr("letting go keeps it, Esc takes it back")};
    return m_open ? QStringList{depth, tr("drag down for deeper, up for shallower")}
                  : QStringList{depth};
}

/// While a drag sets the depth, a scale stands at its beginning: from no depth to what is set.
void PeelTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    OutlineTool::paintOverlay(painter, view);
    if (!m_depthDrag || m_depthDrag->view != view.view)
        return;
    constexpr double tickPixels = 6.0;
    const QPointF& from = m_depthDrag->from;
    const auto heightOf = [this, &from](double mm) {
        return from.y() + (mm - m_depthDrag->fromMm) / m_depthDrag->mmPerPixel;
    };
    const QPointF none(from.x(), heightOf(0.0));
    const QPointF now(from.x(), heightOf(m_depthMm));
    painter.setRenderHint(QPainter::Antialiasing);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 150), 4.0), QPen(toolColour(), 1.6)}) {
        painter.setPen(pen);
        painter.drawLine(none, now);
        painter.drawLine(none - QPointF(tickPixels, 0.0), none + QPointF(tickPixels, 0.0));
        painter.drawLine(
            from - QPointF(tickPixels / 2.0, 0.0), from + QPointF(tickPixels / 2.0, 0.0));
        painter.drawLine(now - QPointF(tickPixels, 0.0), now + QPointF(tickPixels, 0.0));
    }
}

} // namespace ui
