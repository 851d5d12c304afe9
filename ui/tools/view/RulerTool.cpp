// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/RulerTool.h"

#include "core/edits/kinds/views/Measurements.h"
#include "ui/overlays/MeasurementLines.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/SeenVoxels.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QPointer>
#include <QToolButton>

#include <cmath>

namespace ui {

namespace {

/// A click is no measurement.
constexpr double leastPixels = 3.0;

void remove(Workspace& workspace, int measurement)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return;
    const core::RemoveMeasurement edit{.measurement = measurement};
    if (const auto removed = session->apply(edit); !removed)
        workspace.fail(removed.error());
}

} // namespace

RulerTool::RulerTool(Workspace& workspace, QObject* parent)
    : Tool(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_pressedView.reset();
        Q_EMIT overlayChanged();
    });
}

QString RulerTool::name() const
{
    return tr("Ruler");
}

QString RulerTool::iconName() const
{
    return QStringLiteral("ruler");
}

QString RulerTool::hint() const
{
    return tr("Ruler: drag from place to place, in a slice or over what the 3D view shows");
}

QString RulerTool::keys() const
{
    return tr("Esc drops the line");
}

QWidget* RulerTool::createOptions(QWidget* parent)
{
    auto* options = new QWidget(parent);
    auto* layout = new QHBoxLayout(options);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* button = new QToolButton(options);
    button->setObjectName(QStringLiteral("measurements"));
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button);
    button->setMenu(menu);
    layout->addWidget(button);
    const auto show = [this, button] {
        const core::EditSession* session = m_workspace.session();
        const qsizetype count = session ? std::ssize(session->document().measurements) : 0;
        button->setText(count == 1 ? tr("1 measurement") : tr("%1 measurements").arg(count));
        button->setEnabled(count > 0);
    };
    connect(menu, &QMenu::aboutToShow, menu, [this, menu] {
        menu->clear();
        const core::EditSession* session = m_workspace.session();
        if (!session)
            return;
        for (const core::Measurement& each : session->document().measurements)
            menu->addAction(tr("Remove %1: %2").arg(each.id).arg(lengthText(each.lengthMm())), this,
                [this, id = each.id] { remove(m_workspace, id); });
    });
    connect(&m_workspace, &Workspace::documentChanged, button,
        [show](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Measurements)
                show();
        });
    connect(&m_workspace, &Workspace::sessionChanged, button, show);
    show();
    return options;
}

bool RulerTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return !scene || scene->orthographic;
}

void RulerTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.volume() || !worksIn(view) || m_pressedView)
        return;
    m_pressedView = view;
    m_from = m_to = sample.position;
    hover(sample, view);
}

void RulerTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_pressedView || view.view != m_pressedView->view)
        return;
    m_to = sample.position;
    hover(sample, view);
}

void RulerTool::release(const PointerSample&, const ViewContext&)
{
    if (!m_pressedView)
        return;
    const ViewContext view = *m_pressedView;
    m_pressedView.reset();
    const QPointF along = m_to - m_from;
    if (std::hypot(along.x(), along.y()) < leastPixels)
        m_workspace.say(tr("Nothing was measured: drag from one place to the other"));
    else if (view.isSlice())
        keep(view.toLps(m_from), view.toLps(m_to), 0);
    else
        measureWhatIsSeen(view);
    Q_EMIT overlayChanged();
}

void RulerTool::measureWhatIsSeen(const ViewContext& view)
{
    const std::vector<glm::dvec2> ends{view.toViewPlaneMm(m_from), view.toViewPlaneMm(m_to)};
    askWhatIsSeen(m_workspace, std::get<gpu::VolumeScene>(view.scene), ends,
        [tool = QPointer<RulerTool>(this)](const core::Result<SeenVoxels>& seen) {
            if (!tool)
                return;
            if (!seen)
                return tool->m_workspace.fail(seen.error());
            const auto& from = seen->front();
            const auto& to = seen->back();
            if (!from || !to)
                return tool->m_workspace.say(
                    tr("Nothing was measured: nothing is seen at one of the ends"));
            const core::VolumeGeometry& geometry = tool->m_workspace.volume()->geometry;
            tool->keep(geometry.toWorld(glm::dvec3(from->voxel)),
                geometry.toWorld(glm::dvec3(to->voxel)),
                from->piece == to->piece ? from->piece : 0);
        });
}

void RulerTool::keep(const glm::dvec3& fromLps, const glm::dvec3& toLps, int piece)
{
    core::AddMeasurement edit{.fromLps = fromLps, .toLps = toLps, .piece = {}};
    if (piece != 0)
        edit.piece = piece;
    if (const auto kept = m_workspace.session()->apply(edit); !kept)
        return m_workspace.fail(kept.error());
    const QString length = lengthText(glm::distance(fromLps, toLps));
    m_workspace.say(piece != 0 ? tr("%1, true length of the piece").arg(length) : length);
}

void RulerTool::cancel()
{
    if (!m_pressedView)
        return;
    m_pressedView.reset();
    Q_EMIT overlayChanged();
}

void RulerTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_cursor = sample.position;
    m_cursorView = view.view;
    Q_EMIT overlayChanged();
}

void RulerTool::leave()
{
    m_cursorView.reset();
    Q_EMIT overlayChanged();
}

void RulerTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (m_pressedView && m_pressedView->view == view.view) {
        if (view.isSlice()) {
            paintMeasurement(painter, view, m_from, m_to,
                glm::distance(m_pressedView->toLps(m_from), m_pressedView->toLps(m_to)));
        } else {
            // What is seen at its ends is known once it is there.
            painter.setRenderHint(QPainter::Antialiasing);
            painter.setPen(QPen(QColor(0, 0, 0, 170), 3.6));
            painter.drawLine(m_from, m_to);
            painter.setPen(QPen(toolColour(), 1.4, Qt::DashLine));
            painter.drawLine(m_from, m_to);
        }
    } else if (m_cursorView == view.view) {
        drawCursorLabel(painter, view.sizePixels, m_cursor, 4.0, {tr("measures from here")});
    }
}

} // namespace ui
