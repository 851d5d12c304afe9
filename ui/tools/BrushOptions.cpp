// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/BrushOptions.h"

#include "ui/Theme.h"
#include "ui/tools/BrushTool.h"
#include "ui/tools/SeedOptions.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace ui {

namespace {

QDoubleSpinBox* numberBox(QWidget* parent, const char* name)
{
    auto* box = new QDoubleSpinBox(parent);
    box->setObjectName(QLatin1String(name));
    box->setFixedHeight(theme::controlHeight);
    box->setKeyboardTracking(false);
    return box;
}

} // namespace

BrushOptions::BrushOptions(Workspace& workspace, Workspace::Brush brush, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_brush(brush)
    , m_radius(numberBox(this, "brushRadius"))
    , m_shape(new QComboBox(this))
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
        layout->addWidget(new SeedOptions(workspace, tr("Segment"), this));
    layout->addWidget(new QLabel(tr("Radius"), this));
    layout->addWidget(m_radius);
    layout->addWidget(m_shape);
    if (brush == Workspace::Brush::Paint)
        addPaintOptions(*layout);

    showSettings();
    connect(&m_workspace, &Workspace::brushSettingsChanged, this, &BrushOptions::showSettings);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, &BrushOptions::takeSettings);
    connect(m_shape, &QComboBox::activated, this, &BrushOptions::takeSettings);
}

void BrushOptions::addPaintOptions(QHBoxLayout& layout)
{
    m_onlyBetween = new QCheckBox(tr("only values"), this);
    m_onlyBetween->setObjectName(QStringLiteral("brushOnlyBetween"));
    m_onlyBetween->setToolTip(tr("Only voxels whose value lies in an interval change"));
    m_lower = numberBox(this, "brushLower");
    m_upper = numberBox(this, "brushUpper");
    m_overwrite = new QCheckBox(tr("over others"), this);
    m_overwrite->setObjectName(QStringLiteral("brushOverwrite"));
    m_overwrite->setToolTip(tr("Take voxels of other segments that are not locked"));
    for (QDoubleSpinBox* box : {m_lower, m_upper}) {
        box->setDecimals(0);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setRange(-1e6, 1e6);
        box->setFixedWidth(58);
        connect(box, &QDoubleSpinBox::valueChanged, this, &BrushOptions::takeSettings);
    }
    layout.addWidget(m_onlyBetween);
    layout.addWidget(m_lower);
    layout.addWidget(m_upper);
    layout.addWidget(m_overwrite);
    connect(m_onlyBetween, &QCheckBox::clicked, this, &BrushOptions::takeInterval);
    connect(m_overwrite, &QCheckBox::toggled, this, &BrushOptions::takeSettings);
}

void BrushOptions::showSettings()
{
    const Workspace::BrushSettings& settings = m_workspace.brushSettings(m_brush);
    const QSignalBlocker radius(m_radius);
    m_radius->setValue(settings.radiusMm);
    m_shape->setCurrentIndex(m_shape->findData(settings.disc));
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
        box->setVisible(settings.onlyBetween);
    }
    m_lower->setValue(settings.lower);
    m_upper->setValue(settings.upper);
    m_overwrite->setChecked(settings.overwriteUnlocked);
}

void BrushOptions::takeSettings()
{
    Workspace::BrushSettings settings = m_workspace.brushSettings(m_brush);
    settings.radiusMm = m_radius->value();
    settings.disc = m_shape->currentData().toBool();
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
