// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/outline/FillOutlineTool.h"

#include "core/sculpt/labels/LabelOutlined.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/common/PaintLimits.h"
#include "ui/tools/common/SeedOptions.h"
#include "ui/tools/outline/OutlineFilling.h"
#include "ui/workspace/Workspace.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QSignalBlocker>

namespace ui {

FillOutlineTool::FillOutlineTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
    , m_slice(workspace)
    , m_wire(workspace, m_slice)
    , m_level(workspace, m_slice)
{
    connect(&workspace, &Workspace::brushSettingsChanged, this, &FillOutlineTool::stopClosing);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &FillOutlineTool::stopClosing);
    // An outline ends with the session it was begun in.
    connect(&workspace, &Workspace::sessionClosing, this, &FillOutlineTool::cancel);
    connect(&workspace, &Workspace::sessionChanged, this, &FillOutlineTool::cancel);
    connect(&m_wire, &LiveWire::changed, this, &FillOutlineTool::showWire);
    connect(&m_wire, &LiveWire::failed, this, &FillOutlineTool::stopClosing);
    connect(&m_level, &LevelTrace::changed, this, &FillOutlineTool::showLevel);
    connect(&m_level, &LevelTrace::failed, this, &FillOutlineTool::stopClosing);
    // Its slice is looked at before anything is drawn: while it is, the slice could not be read.
    connect(&m_slice, &ReadSlice::dropped, this, [this] {
        if (m_closes || (m_outline.drawing() && m_shape == Shape::Livewire))
            cancel();
    });
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

QString FillOutlineTool::target() const
{
    return fillingText(m_workspace, m_erases);
}

QString FillOutlineTool::keys() const
{
    return tr("Enter closes, Backspace takes a corner back · Ctrl erases · Esc cancels");
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
    shapes->addItem(tr("livewire"), int(Shape::Livewire));
    shapes->addItem(tr("level trace"), int(Shape::Level));
    shapes->setToolTip(tr("Draw a curve, click corner by corner, or drag from corner to corner; "
                          "livewire: click along an edge, and the outline follows it; level trace: "
                          "point at a value, and a click fills its contour"));
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
    if (shape >= int(Shape::Lasso) && shape <= int(Shape::Level))
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

bool FillOutlineTool::isClicked() const
{
    return m_shape == Shape::Polygon || m_shape == Shape::Livewire;
}

void FillOutlineTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.session() || !worksIn(view) || m_pressed || m_closes)
        return;
    follow(sample, view);
    if (m_shape == Shape::Livewire && m_slice.lattice().empty())
        return m_workspace.say(howToDraw()); // the slice misses the volume
    if (m_outline.drawing()) {
        pressCorner(sample, view);
    } else {
        m_erases = isInverse(sample);
        m_view = view;
        m_pressed = true;
        if (m_shape != Shape::Level)
            m_outline.begin(m_shape, sample.position, view);
        if (m_shape == Shape::Livewire) {
            m_wire.addAnchor(view.toLps(sample.position));
            showWire();
        }
        Q_EMIT stepsChanged();
    }
    showCursor(sample.position, view.view);
}

void FillOutlineTool::pressCorner(const PointerSample& sample, const ViewContext& view)
{
    if (!m_outline.liesIn(view))
        return m_workspace.say(
            tr("The outline lies in another slice: go back to it, or drop it with Esc"));
    const bool ends = m_outline.endsAt(sample.position, view)
        || (m_shape == Shape::Livewire && m_wire.endsAt(view.toLps(sample.position)));
    if (ends) {
        // With fewer corners a double click has meant nothing yet.
        m_view = view;
        if (isMeant())
            close();
        return;
    }
    m_view = view;
    m_pressed = true;
    if (m_shape == Shape::Livewire) {
        m_wire.addAnchor(view.toLps(sample.position));
        showWire();
    } else {
        m_outline.addCorner(sample.position, view);
    }
    Q_EMIT stepsChanged();
}

void FillOutlineTool::follow(const PointerSample& sample, const ViewContext& view)
{
    // What is closed is still to be filled where it was, and a wire stays in its slice.
    if (m_closes || m_outline.drawing())
        return;
    if (m_shape != Shape::Livewire && m_shape != Shape::Level)
        return;
    m_slice.look(view);
    if (m_shape != Shape::Level)
        return;
    m_levelView = view;
    m_level.pointAt(view.toLps(sample.position));
}

void FillOutlineTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (m_pressed && view.view == m_view->view) {
        if (m_shape == Shape::Level)
            follow(sample, view);
        else if (m_shape != Shape::Livewire) // an anchor stays where it was set
            m_outline.extend(sample.position, *m_view);
    }
    showCursor(sample.position, view.view);
}

void FillOutlineTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_pressed)
        return;
    drag(sample, view);
    m_pressed = false;
    if (!isClicked())
        close();
    showCursor(sample.position, view.view);
}

void FillOutlineTool::showWire()
{
    if (m_outline.drawing() && m_shape == Shape::Livewire)
        m_outline.setCorners(m_wire.wireLps());
    if (m_closes)
        closeIfKnown();
    Q_EMIT overlayChanged();
}

void FillOutlineTool::showLevel()
{
    if (m_level.contour() && !isRagged())
        m_levelOutline.lay(Shape::Level, m_level.contourLps(), *m_levelView);
    else
        m_levelOutline.drop();
    if (m_closes)
        closeIfKnown();
    Q_EMIT overlayChanged();
}

bool FillOutlineTool::isMeant() const
{
    switch (m_shape) {
    case Shape::Livewire:
        // With two the outline would come back the way it went.
        return m_wire.anchorCount() >= 3;
    case Shape::Level:
        return m_level.pointsAtPixel();
    case Shape::Lasso:
    case Shape::Polygon:
    case Shape::Rectangle:
    case Shape::Ellipse:
        break;
    }
    return m_outline.isMeant(*m_view);
}

QString FillOutlineTool::howToDraw() const
{
    switch (m_shape) {
    case Shape::Polygon:
        return tr("A polygon has three corners or more");
    case Shape::Livewire:
        return tr("Click at three places of the edge or more; the wire follows it between them");
    case Shape::Level:
        return tr("Point at the picture; the contour of the value there is filled");
    case Shape::Lasso:
    case Shape::Rectangle:
    case Shape::Ellipse:
        break;
    }
    return tr("Draw around what is to be filled; the outline closes by itself");
}

void FillOutlineTool::close()
{
    if (!isMeant()) {
        if (!isClicked())
            drop();
        return m_workspace.say(howToDraw());
    }
    m_closes = true;
    closeIfKnown();
}

void FillOutlineTool::closeIfKnown()
{
    SliceOutline outline = m_outline;
    if (m_shape == Shape::Livewire) {
        if (!m_wire.isKnown())
            return;
        std::vector<glm::dvec3> corners = m_wire.wireLps();
        const std::vector<glm::dvec3> closing = m_wire.closingLps();
        corners.insert(corners.end(), closing.begin(), closing.end());
        outline.setCorners(corners);
    } else if (m_shape == Shape::Level) {
        if (!m_level.isKnown())
            return;
        if (isRagged()) {
            stopClosing();
            return m_workspace.say(
                tr("This contour is too ragged to be filled: point at another value"));
        }
        outline = m_levelOutline;
    }
    m_closes = false;
    if (!isClicked())
        drop();
    if (fillOutline(m_workspace, outline, m_erases))
        drop();
}

void FillOutlineTool::stopClosing()
{
    if (m_closes && !isClicked())
        m_outline.drop();
    m_closes = false;
    Q_EMIT overlayChanged();
}

bool FillOutlineTool::isRagged() const
{
    return m_level.contour()
        && m_level.contour()->corners.size() > core::LabelOutlined::mostCorners;
}

void FillOutlineTool::drop()
{
    m_outline.drop();
    m_wire.drop();
    Q_EMIT overlayChanged();
    Q_EMIT stepsChanged();
}

void FillOutlineTool::cancel()
{
    m_pressed = false;
    m_closes = false;
    drop();
}

bool FillOutlineTool::canTakeStepBack() const
{
    return m_outline.drawing() && isClicked();
}

void FillOutlineTool::takeStepBack()
{
    if (!canTakeStepBack())
        return;
    // The pen may still be down on that corner.
    m_pressed = false;
    m_closes = false;
    if (m_shape == Shape::Livewire) {
        m_wire.removeAnchor();
        showWire();
    } else {
        m_outline.removeCorner();
    }
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
        close();
    else
        return false;
    return true;
}

void FillOutlineTool::hover(const PointerSample& sample, const ViewContext& view)
{
    if (!m_outline.drawing() && !m_closes)
        m_erases = isInverse(sample);
    follow(sample, view);
    showCursor(sample.position, view.view);
}

void FillOutlineTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !worksIn(view))
        return;
    const bool underPointer = isUnderPointer(view);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_outline.drawing() && m_outline.liesIn(view)) {
        QPolygonF shown = m_outline.pixels(view);
        if (underPointer && !m_pressed && m_shape == Shape::Polygon)
            shown << cursor(); // the corner that a click would add
        if (underPointer && m_shape == Shape::Livewire) {
            for (const glm::dvec3& corner : m_wire.onwardsLps(view.toLps(cursor())))
                shown << view.toPixel(corner);
        }
        paintFilling(painter, m_workspace, shown, m_erases, !isClicked());
        if (isClicked()) {
            painter.setPen(QPen(toolColour(), 1.4));
            painter.drawEllipse(m_outline.firstPixel(view), 4.0, 4.0); // where a click closes it
        }
    }
    const bool showsLevel = m_shape == Shape::Level && underPointer && m_levelOutline.drawing()
        && m_levelOutline.liesIn(view);
    if (showsLevel)
        paintFilling(painter, m_workspace, m_levelOutline.pixels(view), m_erases, true);
    if (!underPointer)
        return;
    painter.setBrush(toolColour());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(cursor(), 2.0, 2.0);
    QStringList lines{target()};
    if (showsLevel)
        lines += levelText();
    else if (m_shape == Shape::Level && isRagged())
        lines += tr("too ragged to be filled");
    if (const QString limits = limitsText(m_workspace); !limits.isEmpty())
        lines += limits;
    drawCursorLabel(painter, view.sizePixels, cursor(), 6.0, lines);
}

/// What lies inside the contour: "from 120 HU".
QString FillOutlineTool::levelText() const
{
    const core::Volume& volume = *m_workspace.volume();
    const core::LevelContour& contour = *m_level.contour();
    const QString value = valueText(
        volume.encoding.value(contour.level), volume.unit, volume.maximum - volume.minimum);
    return contour.brighter ? tr("from %1").arg(value) : tr("up to %1").arg(value);
}

} // namespace ui
