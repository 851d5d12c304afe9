// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/BrushOptions.h"

#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/tools/common/BrushTool.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/tools/common/SeedOptions.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidgetAction>

#include <algorithm>

namespace ui {

namespace {

constexpr int longestLimitsPixels = 96; ///< so that the bar fits into 1280 pixels

QDoubleSpinBox* numberBox(QWidget* parent, const char* name)
{
    auto* box = new QDoubleSpinBox(parent);
    box->setObjectName(QLatin1String(name));
    box->setFixedHeight(theme::controlHeight);
    box->setKeyboardTracking(false);
    return box;
}

} // namespace

QString intervalText(const Workspace& workspace)
{
    const Workspace::BrushSettings& settings = workspace.brushSettings(Workspace::Brush::Paint);
    const core::Volume* volume = workspace.volume();
    if (!settings.onlyBetween || !volume)
        return {};
    const double span = volume->maximum - volume->minimum;
    return QObject::tr("only %1 … %2")
        .arg(valueText(std::min(settings.lower, settings.upper), {}, span).trimmed(),
            valueText(std::max(settings.lower, settings.upper), volume->unit, span));
}

BrushOptions::BrushOptions(Workspace& workspace, Workspace::Brush brush, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_brush(brush)
    , m_radius(numberBox(this, "brushRadius"))
    , m_shape(new QComboBox(this))
    , m_pressure(pressureButton(this))
{
    m_radius->setRange(BrushTool::minimumRadiusMm, BrushTool::maximumRadiusMm);
    m_radius->setDecimals(1);
    m_radius->setSingleStep(0.5);
    m_radius->setSuffix(tr(" mm"));
    m_shape->setObjectName(QStringLiteral("brushShape"));
    m_shape->setFixedHeight(theme::controlHeight);
    m_shape->addItem(tr("ball"), false);
    m_shape->addItem(tr("this slice"), true);
    m_shape->setToolTip(tr("On slices: a ball through all slices, or a disc in the shown one only. "
                           "In 3D it is a ball."));

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    if (brush == Workspace::Brush::Paint)
        layout->addWidget(new SeedOptions(workspace, {}, this));
    layout->addWidget(new QLabel(tr("Radius"), this));
    layout->addWidget(m_radius);
    layout->addWidget(m_pressure);
    layout->addWidget(m_shape);
    if (brush == Workspace::Brush::Paint)
        addPaintOptions(*layout);

    showSettings();
    connect(&m_workspace, &Workspace::brushSettingsChanged, this, &BrushOptions::showSettings);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, &BrushOptions::takeSettings);
    connect(m_shape, &QComboBox::activated, this, &BrushOptions::takeSettings);
    connect(m_pressure, &QToolButton::clicked, this, &BrushOptions::takeSettings);
}

void BrushOptions::addPaintOptions(QHBoxLayout& layout)
{
    // In a small window of its own: the bar has no room, but says what holds.
    m_limits = new QToolButton(this);
    m_limits->setObjectName(QStringLiteral("brushLimits"));
    m_limits->setFixedHeight(theme::controlHeight);
    m_limits->setPopupMode(QToolButton::InstantPopup);
    m_limits->setToolButtonStyle(Qt::ToolButtonTextOnly);
    auto* menu = new QMenu(this);
    auto* content = new QWidget(menu);
    m_onlyBetween = new QCheckBox(tr("only values from"), content);
    m_onlyBetween->setObjectName(QStringLiteral("brushOnlyBetween"));
    m_lower = numberBox(content, "brushLower");
    m_upper = numberBox(content, "brushUpper");
    m_overwrite = new QCheckBox(tr("over other segments that are not locked"), content);
    m_overwrite->setObjectName(QStringLiteral("brushOverwrite"));
    for (QDoubleSpinBox* box : {m_lower, m_upper}) {
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setRange(-1e6, 1e6);
        box->setFixedWidth(96);
        connect(box, &QDoubleSpinBox::valueChanged, this, &BrushOptions::takeSettings);
    }
    auto* interval = new QHBoxLayout;
    interval->setSpacing(theme::smallPadding);
    interval->addWidget(m_onlyBetween);
    interval->addWidget(m_lower);
    interval->addWidget(new QLabel(tr("to"), content));
    interval->addWidget(m_upper);
    interval->addStretch(1);
    auto* rows = new QVBoxLayout(content);
    rows->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    rows->setSpacing(theme::smallPadding);
    rows->addLayout(interval);
    rows->addWidget(m_overwrite);
    auto* action = new QWidgetAction(menu);
    action->setDefaultWidget(content);
    menu->addAction(action);
    m_limits->setMenu(menu);
    layout.addWidget(m_limits);
    connect(m_onlyBetween, &QCheckBox::clicked, this, &BrushOptions::takeInterval);
    connect(m_overwrite, &QCheckBox::toggled, this, &BrushOptions::takeSettings);
}

void BrushOptions::showSettings()
{
    const Workspace::BrushSettings& settings = m_workspace.brushSettings(m_brush);
    const QSignalBlocker radius(m_radius);
    m_radius->setValue(settings.radiusMm);
    m_shape->setCurrentIndex(m_shape->findData(settings.disc));
    m_pressure->setChecked(settings.radiusByPressure);
    if (!m_onlyBetween)
        return;
    const QSignalBlocker only(m_onlyBetween);
    const QSignalBlocker lower(m_lower);
    const QSignalBlocker upper(m_upper);
    const QSignalBlocker overwrite(m_overwrite);
    m_onlyBetween->setChecked(settings.onlyBetween);
    const core::Volume* volume = m_workspace.volume();
    for (QDoubleSpinBox* box : {m_lower, m_upper}) {
        // A volume of fractions needs them here too.
        box->setDecimals(volume && volume->maximum - volume->minimum < 50.0 ? 3 : 0);
        box->setSuffix(volume ? QLatin1Char(' ') + volume->unit : QString());
        box->setEnabled(settings.onlyBetween);
    }
    QStringList limits;
    if (settings.onlyBetween)
        limits += intervalText(m_workspace);
    if (settings.overwriteUnlocked)
        limits += tr("over others");
    const QString text = limits.isEmpty() ? tr("no limits") : limits.join(QStringLiteral(", "));
    m_limits->setText(
        m_limits->fontMetrics().elidedText(text, Qt::ElideRight, longestLimitsPixels));
    m_limits->setToolTip(tr("Which voxels may change: %1").arg(text));
    m_lower->setValue(settings.lower);
    m_upper->setValue(settings.upper);
    m_overwrite->setChecked(settings.overwriteUnlocked);
}

void BrushOptions::takeSettings()
{
    Workspace::BrushSettings settings = m_workspace.brushSettings(m_brush);
    settings.radiusMm = m_radius->value();
    settings.disc = m_shape->currentData().toBool();
    settings.radiusByPressure = m_pressure->isChecked();
    if (m_onlyBetween) {
        settings.lower = m_lower->value();
        settings.upper = m_upper->value();
        settings.overwriteUnlocked = m_overwrite->isChecked();
    }
    m_workspace.setBrushSettings(m_brush, settings);
}

void BrushOptions::takeInterval()
{
    Workspace::BrushSettings settings = m_workspace.brushSettings(m_brush);
    settings.onlyBetween = m_onlyBetween->isChecked();
    if (settings.onlyBetween && !(settings.lower < settings.upper)) {
        // The growth's interval is what the user looks for more often than not.
        const Workspace::GrowSettings& growth = m_workspace.growSettings();
        const core::Volume* volume = m_workspace.volume();
        const bool known = growth.lower < growth.upper;
        settings.lower = known ? growth.lower : volume ? volume->minimum : 0.0;
        settings.upper = known ? growth.upper : volume ? volume->maximum : 1.0;
    }
    m_workspace.setBrushSettings(m_brush, settings);
}

} // namespace ui
