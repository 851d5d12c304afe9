// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentLookEntries.h"

#include "ui/base/Theme.h"
#include "ui/menus/SliderRow.h"

#include <QActionGroup>
#include <QMenu>
#include <QSlider>

#include <array>
#include <utility>

namespace ui {

namespace {

using Look = Workspace::SegmentLook;

struct DrawingChoice {
    const char* id;
    QString text;
    Workspace::SegmentDrawing drawing;
};

std::array<DrawingChoice, 3> drawingChoices()
{
    using Drawing = Workspace::SegmentDrawing;
    return {{{"fillAndOutlineHere", QObject::tr("Fill and outline"), Drawing::FillAndOutline},
        {"fillHere", QObject::tr("Fill"), Drawing::Fill},
        {"outlineHere", QObject::tr("Outline"), Drawing::Outline}}};
}

/// What is drawn, and how opaque the fill is: "Outline", "Fill, 60 %".
QString drawnText(const Workspace::DrawnSegments& drawn)
{
    QString text;
    for (const DrawingChoice& each : drawingChoices()) {
        if (each.drawing == drawn.drawing)
            text = each.text;
    }
    return drawn.drawing == Workspace::SegmentDrawing::Outline
        ? text
        : QObject::tr("%1, %2 %").arg(text).arg(drawn.fillPercent);
}

} // namespace

void addSegmentLook(QMenu& menu, Workspace& workspace, const LookOfView& look)
{
    const Workspace::DrawnSegments drawn = workspace.drawnSegments(look.get());
    auto* onlyOne = new QActionGroup(&menu);
    for (const DrawingChoice& each : drawingChoices()) {
        QAction* action = menu.addAction(each.text, &workspace, [look, drawing = each.drawing] {
            Look changed = look.get();
            changed.drawing = drawing;
            look.set(changed);
        });
        action->setObjectName(QLatin1String(each.id));
        action->setCheckable(true);
        action->setChecked(each.drawing == drawn.drawing);
        onlyOne->addAction(action);
    }
    const bool isFilled = drawn.drawing != Workspace::SegmentDrawing::Outline;
    auto* asAll = new QAction(QObject::tr("As in all views"), &menu);
    QSlider* fill = addSliderRow(menu,
        {.id = "fillPercentHere",
            .text = QObject::tr("Fill"),
            .accessibleName = QObject::tr("Opacity of the fill in this view"),
            .tip = isFilled ? QObject::tr("How opaque segments are filled in this view")
                            : QObject::tr("Segments are not filled in this view"),
            .least = Workspace::leastSegmentFill,
            .now = drawn.fillPercent,
            .changed = [look, asAll](int percent) {
                Look changed = look.get();
                changed.fillPercent = percent;
                look.set(changed);
                asAll->setEnabled(true);
            }});
    fill->setEnabled(isFilled);
    menu.addSeparator();
    asAll->setObjectName(QStringLiteral("lookAsInAllViews"));
    asAll->setEnabled(!look.get().isUsual());
    asAll->setToolTip(QObject::tr("This view follows View > Segments in slices again"));
    QObject::connect(asAll, &QAction::triggered, &workspace, [look] { look.set({}); });
    menu.addAction(asAll);
}

SegmentLookButton::SegmentLookButton(Workspace& workspace, LookOfView look, QWidget* view)
    : QToolButton(view)
    , m_workspace(workspace)
    , m_look(std::move(look))
{
    setObjectName(QStringLiteral("segmentLookButton"));
    setAccessibleName(tr("Segments in this view"));
    setCursor(Qt::ArrowCursor);
    setFont(theme::smallFont());
    // A click leaves the keys with the view.
    setFocusPolicy(Qt::TabFocus);
    connect(this, &QToolButton::clicked, this, [this] {
        auto* menu = new QMenu(this);
        menu->setObjectName(QStringLiteral("segmentLookMenu"));
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->setToolTipsVisible(true);
        addSegmentLook(*menu, m_workspace, m_look);
        menu->popup(mapToGlobal(QPoint(0, height())));
    });
    connect(&workspace, &Workspace::viewOptionsChanged, this, &SegmentLookButton::showState);
    hide();
}

void SegmentLookButton::showState()
{
    // In pixels: the slice's number and the scale bar are below it, the bar of colours beside it.
    constexpr int overScaleBar = 58;
    constexpr int besideColours = 80;
    const Look look = m_look.get();
    setText(drawnText(m_workspace.drawnSegments(look)));
    setToolTip(tr("This view draws segments in its own way"));
    setVisible(!look.isUsual() && m_workspace.volume());
    adjustSize();
    const bool hasColours = m_workspace.viewOptions().colours != gpu::ColourMap::Grey;
    move(parentWidget()->width() - theme::padding - (hasColours ? besideColours : 0) - width(),
        parentWidget()->height() - overScaleBar - height());
}

} // namespace ui
