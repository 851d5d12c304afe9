// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentOpacity.h"

#include "ui/base/Theme.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSlider>
#include <QWheelEvent>
#include <QWidgetAction>

namespace ui {

namespace {

constexpr int opacitySliderWidth = 110;
constexpr int besideIcons = 12; ///< so that the word stands below those of other entries

/// What the slider stands in. Nothing scrolls here, so the wheel moves the slider, which has no
/// focus as a rule and then leaves the wheel to what it stands in (FieldManners).
class OpacityRow : public QWidget {
public:
    explicit OpacityRow(QWidget* parent)
        : QWidget(parent)
        , slider(new QSlider(Qt::Horizontal, this))
    {
    }
    QSlider* const slider;

protected:
    void wheelEvent(QWheelEvent* event) override
    {
        m_turned += event->angleDelta().y();
        const int notches = m_turned / QWheelEvent::DefaultDeltasPerStep;
        m_turned -= notches * QWheelEvent::DefaultDeltasPerStep;
        slider->setValue(slider->value() + notches * slider->singleStep());
        event->accept();
    }

private:
    int m_turned = 0; ///< less than a notch, in eighths of a degree
};

QString opacityText(int percent)
{
    return QObject::tr("%1 %").arg(percent);
}

} // namespace

void addSegmentOpacity(QMenu& menu, Workspace& workspace, int label)
{
    auto* row = new OpacityRow(&menu);
    auto* name = new QLabel(QObject::tr("Opacity"), row);
    QSlider* slider = row->slider;
    slider->setObjectName(QStringLiteral("segmentOpacity"));
    slider->setAccessibleName(QObject::tr("Opacity of the segment"));
    slider->setToolTip(QObject::tr("How opaque the segment is in slices and in the 3D view"));
    slider->setRange(Workspace::leastSegmentOpacity, 100);
    slider->setSingleStep(5);
    slider->setPageStep(10);
    slider->setFixedWidth(opacitySliderWidth);
    slider->setValue(workspace.segmentOpacity(label));
    auto* number = new QLabel(opacityText(slider->value()), row);
    // As wide as the longest, so that the menu keeps its width.
    number->setMinimumWidth(number->fontMetrics().horizontalAdvance(opacityText(100)));
    name->setBuddy(slider);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(
        theme::padding + besideIcons, theme::smallPadding, theme::padding, theme::smallPadding);
    layout->addWidget(name);
    layout->addWidget(slider);
    layout->addWidget(number);
    QObject::connect(slider, &QSlider::valueChanged, row, [&workspace, number, label](int percent) {
        number->setText(opacityText(percent));
        workspace.setSegmentOpacity(label, percent);
    });
    auto* action = new QWidgetAction(&menu);
    action->setText(QObject::tr("Opacity"));
    action->setDefaultWidget(row);
    menu.addAction(action);
}

} // namespace ui
