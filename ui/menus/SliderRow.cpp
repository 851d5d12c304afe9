// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SliderRow.h"

#include "ui/base/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSlider>
#include <QWheelEvent>
#include <QWidgetAction>

namespace ui {

namespace {

constexpr int menuSliderWidth = 110;
constexpr int besideIcons = 12; ///< so that the word stands below those of other entries

/// What the slider stands in. Nothing scrolls here, so the wheel moves the slider, which has no
/// focus as a rule and then leaves the wheel to what it stands in (FieldManners).
class WheelRow : public QWidget {
public:
    explicit WheelRow(QWidget* parent)
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
        if (slider->isEnabled())
            slider->setValue(slider->value() + notches * slider->singleStep());
        event->accept();
    }

private:
    int m_turned = 0; ///< less than a notch, in eighths of a degree
};

QString percentText(int percent)
{
    return QObject::tr("%1 %").arg(percent);
}

} // namespace

QSlider* addSliderRow(QMenu& menu, const SliderRow& row)
{
    auto* body = new WheelRow(&menu);
    auto* name = new QLabel(row.text, body);
    QSlider* slider = body->slider;
    slider->setObjectName(QLatin1String(row.id));
    slider->setAccessibleName(row.accessibleName);
    slider->setToolTip(row.tip);
    slider->setRange(row.least, 100);
    slider->setSingleStep(5);
    slider->setPageStep(10);
    slider->setFixedWidth(menuSliderWidth);
    slider->setValue(row.now);
    auto* number = new QLabel(percentText(slider->value()), body);
    // As wide as the longest, so that the menu keeps its width.
    number->setMinimumWidth(number->fontMetrics().horizontalAdvance(percentText(100)));
    name->setBuddy(slider);
    auto* layout = new QHBoxLayout(body);
    layout->setContentsMargins(
        theme::padding + besideIcons, theme::smallPadding, theme::padding, theme::smallPadding);
    layout->addWidget(name);
    layout->addWidget(slider);
    layout->addWidget(number);
    QObject::connect(
        slider, &QSlider::valueChanged, body, [number, changed = row.changed](int percent) {
            number->setText(percentText(percent));
            changed(percent);
        });
    auto* action = new QWidgetAction(&menu);
    action->setText(row.text);
    action->setDefaultWidget(body);
    menu.addAction(action);
    return slider;
}

} // namespace ui
