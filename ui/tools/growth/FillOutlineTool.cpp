// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/FillOutlineTool.h"

#include "core/edits/kinds/segments/FillOutline.h"
#include "ui/base/Theme.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/DrillMask.h"
#include "ui/tools/common/PaintLimits.h"
#include "ui/tools/common/SeedOptions.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QSignalBlocker>

#include <algorithm>

namespace ui {

FillOutlineTool::FillOutlineTool(Workspace& workspace, QObject* parent)
    : Tool(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::brushSettingsChanged, this, &Tool::overlayChanged);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &Tool::overlayChanged);
    // An outline ends with the session it was begun in.
    connect(&workspace, &Workspace::sessionChanged, this, &FillOutlineTool::cancel);
}

QString FillOutlineTool::name() const
{
    return tr("Outline");
}

QString FillOutlineTool::iconName() const
{
    return QStringLiteral("fill-outline");
}

QString FillOutlineTool::hint() const
{
    return tr("Fill outline: draw around a region on a slice; Ctrl or the eraser end erases it");
}

QString FillOutlineTool::keys() const
{
    return tr("polygon: Enter closes, Backspace takes a corner back · Ctrl erases · Esc cancels");
}

QWidget* FillOutlineTool::createOptions(QWidget* parent)
{
    auto* options = new QWidget(parent);
    auto* layout = new QHBoxLayout(options);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(new SeedOptions(m_workspace, {}, options));
    auto* shapes = new QComboBox(options);
    shapes->setObjectName(QStringLiteral("outlineShape"));
    shapes->setFixedHeight(theme::controlHeight);
    shapes->addItem(tr("lasso"), int(Shape::Lasso));
    shapes->addItem(tr("polygon"), int(Shape::Polygon));
    shapes->addItem(tr("rectangle"), int(Shape::Rectangle));
    shapes->addItem(tr("ellipse"), int(Shape::Ellipse));
    shapes->setToolTip(tr("Draw a curve, click corner by corner, or drag from corner to corner"));
    layout->addWidget(shapes);
    layout->addWidget(new PaintLimits(m_workspace, options));
    const auto show = [this, shapes] {
        const QSignalBlocker blocker(shapes);
        shapes->setCurrentIndex(shapes->findData(int(m_shape)));
    };
    show();
    connect(this, &FillOutlineTool::shapeChanged, shapes, show);
    connect(shapes, &QComboBox::activated, this,
        [this, shapes] { setShape(Shape(shapes->currentData().toInt())); });
    return options;
}

QJsonObject FillOutlineTool::settingsJson() const
{
    return {{QStringLiteral("shape"), int(m_shape)}};
}

void FillOutlineTool::applySettings(const QJsonObject& settings)
{
    const int shape = settings[QLatin1String("shape")].toInt(-1);
    if (shape >= int(Shape::Lasso) && shape <= int(Shape::Ellipse))
        setShape(Shape(shape));
}

void FillOutlineTool::setShape(Shape shape)
{
    if (shape == m_shape)
        return;
    cancel();
    m_shape = shape;
    Q_EMIT shapeChanged();
    Q_EMIT overlayChanged();
}

bool FillOutlineTool::isInverse(const PointerSample& sample)
{
    return sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
}

void FillOutlineTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.session() || !worksIn(view) || m_pressed)
        return;
    if (m_outline.drawing()) {
        pressCorner(sample, view);
    } else {
        m_outline.begin(m_shape, sample.position, view);
        m_erases = isInverse(sample);
        m_view = view;
        m_pressed = true;
        Q_EMIT stepsChanged();
    }
    showCursor(sample, view);
}

void FillOutlineTool::pressCorner(const PointerSample& sample, const ViewContext& view)
{
    if (!m_outline.liesIn(view))
        return m_workspace.say(
            tr("The polygon lies in another slice: go back to it, or drop it with Esc"));
    if (m_outline.endsAt(sample.position, view)) {
        // With fewer corners a double click has meant nothing yet.
        if (m_outline.isMeant(view))
            close(view);
        return;
    }
    m_outline.addCorner(sample.position, view);
    m_view = view;
    m_pressed = true;
    Q_EMIT stepsChanged();
}

void FillOutlineTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (m_pressed && view.view == m_view->view)
        m_outline.extend(sample.position, *m_view);
    showCursor(sample, view);
}

void FillOutlineTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_pressed)
        return;
    drag(sample, view);
    m_pressed = false;
    if (m_outline.shape() != Shape::Polygon)
        close(*m_view);
    showCursor(sample, view);
}

void FillOutlineTool::close(const ViewContext& view)
{
    core::FillOutline edit{.segment = 0,
        .originLps = m_outline.originLps(),
        .rightLps = m_outline.rightLps(),
        .upLps = m_outline.upLps(),
        .polygonMm = m_outline.polygonMm(),
        .erase = m_erases};
    const bool meant = m_outline.isMeant(view);
    const bool isPolygon = m_outline.shape() == Shape::Polygon;
    if (!isPolygon)
        drop();
    if (!meant)
        return m_workspace.say(isPolygon
                ? tr("A polygon has three corners or more")
                : tr("Draw around what is to be filled; the outline closes by itself"));
    if (m_erases && m_workspace.session()->document().segments.empty())
        return m_workspace.say(tr("There is no segment to erase"));
    const core::Result<int> label = ensureActiveSegment(m_workspace);
    if (!label)
        return m_workspace.fail(label.error());
    const Workspace::BrushSettings& limits = m_workspace.brushSettings(Workspace::Brush::Paint);
    edit.segment = *label;
    edit.overwriteUnlocked = limits.overwriteUnlocked && !edit.erase;
    if (limits.onlyBetween) {
        edit.lower = std::min(limits.lower, limits.upper);
        edit.upper = std::max(limits.lower, limits.upper);
    }
    if (const auto applied = m_workspace.session()->apply(edit); !applied)
        return m_workspace.fail(applied.error());
    drop();
}

void FillOutlineTool::drop()
{
    m_outline.drop();
    Q_EMIT overlayChanged();
    Q_EMIT stepsChanged();
}

void FillOutlineTool::cancel()
{
    m_pressed = false;
    drop();
}

bool FillOutlineTool::canTakeStepBack() const
{
    return m_outline.drawing() && m_outline.shape() == Shape::Polygon;
}

void FillOutlineTool::takeStepBack()
{
    if (!canTakeStepBack())
        return;
    // The pen may still be down on that corner.
    m_pressed = false;
    m_outline.removeCorner();
    Q_EMIT overlayChanged();
    Q_EMIT stepsChanged();
}

bool FillOutlineTool::pressKey(int key)
{
    if (!canTakeStepBack() || m_pressed)
        return false;
    if (key == Qt::Key_Backspace)
        takeStepBack();
    else if (key == Qt::Key_Return || key == Qt::Key_Enter)
        close(*m_view);
    else
        return false;
    return true;
}

void FillOutlineTool::hover(const PointerSample& sample, const ViewContext& view)
{
    if (!m_outline.drawing())
        m_erases = isInverse(sample);
    showCursor(sample, view);
}

void FillOutlineTool::leave()
{
    m_cursorView.reset();
    Q_EMIT overlayChanged();
}

void FillOutlineTool::showCursor(const PointerSample& sample, const ViewContext& view)
{
    m_cursor = sample.position;
    m_cursorView = view.view;
    Q_EMIT overlayChanged();
}

QString FillOutlineTool::action(bool erases) const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return {};
    const core::Segment* segment = session->document().segment(m_workspace.activeSegment());
    if (!segment)
        return erases ? tr("no segment to erase") : tr("fills a new segment");
    if (segment->locked)
        return tr("%1 is locked").arg(segment->name);
    return (erases ? tr("erases %1") : tr("fills %1")).arg(segment->name);
}

QColor FillOutlineTool::colour() const
{
    const core::Document& document = m_workspace.session()->document();
    const core::Segment* segment = document.segment(m_workspace.activeSegment());
    return segment ? QColor(segment->rgb) : QColor(nextSegmentColour(document));
}

void FillOutlineTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !worksIn(view))
        return;
    const bool underPointer = m_cursorView == view.view;
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_outline.drawing() && m_outline.liesIn(view)) {
        QPolygonF shown = m_outline.pixels(view);
        const bool isPolygon = m_outline.shape() == Shape::Polygon;
        if (isPolygon && underPointer && !m_pressed)
            shown << m_cursor; // the corner that a click would add
        // What would be filled, as the edit counts it: whatever the outline winds around.
        QColor tint = colour();
        tint.setAlpha(70);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_erases ? QBrush(tint, Qt::BDiagPattern) : QBrush(tint));
        painter.drawPolygon(shown, Qt::WindingFill);
        painter.setBrush(Qt::NoBrush);
        drawToolOutline(painter, shown, !isPolygon);
        if (isPolygon) {
            painter.setPen(QPen(toolColour(), 1.4));
            painter.drawEllipse(m_outline.firstPixel(view), 4.0, 4.0); // where a click closes it
        }
    }
    if (!underPointer)
        return;
    painter.setBrush(toolColour());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(m_cursor, 2.0, 2.0);
    QStringList lines{action(m_erases)};
    if (const QString limits = intervalText(m_workspace); !limits.isEmpty())
        lines += limits;
    drawCursorLabel(painter, view.sizePixels, m_cursor, 6.0, lines);
}

} // namespace ui
