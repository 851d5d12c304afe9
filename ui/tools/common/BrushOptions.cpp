// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/BrushOptions.h"

#include "ui/base/Theme.h"
#include "ui/tools/common/BrushTool.h"
#include "ui/tools/common/EdgeOptions.h"
#include "ui/tools/common/PaintLimits.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/tools/common/SeedOptions.h"
#include "ui/widgets/fields/NumberField.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include <array>

namespace ui {

namespace {

struct BrushShape {
    const char* name;
    bool disc;
    bool square;
};
constexpr std::array<BrushShape, 4> brushShapes{{
    {QT_TRANSLATE_NOOP("ui::BrushOptions", "ball"), false, false},
    {QT_TRANSLATE_NOOP("ui::BrushOptions", "disc"), true, false},
    {QT_TRANSLATE_NOOP("ui::BrushOptions", "square"), true, true},
    {QT_TRANSLATE_NOOP("ui::BrushOptions", "cube"), false, true},
}};

} // namespace

BrushOptions::BrushOptions(Workspace& workspace, Workspace::Brush brush, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_brush(brush)
    , m_radius(new NumberField(this))
    , m_shape(new QComboBox(this))
    , m_pressure(pressureButton(this))
{
    m_radius->setObjectName(QStringLiteral("brushRadius"));
    m_radius->setFixedHeight(theme::controlHeight);
    m_radius->setKeyboardTracking(false);
    m_radius->setRange(BrushTool::minimumRadiusMm, BrushTool::maximumRadiusMm);
    m_radius->setDecimals(1);
    m_radius->setSingleStep(0.5);
    m_radius->setSuffix(tr(" mm"));
    m_shape->setObjectName(QStringLiteral("brushShape"));
    m_shape->setFixedHeight(theme::controlHeight);
    for (const BrushShape& shape : brushShapes)
        m_shape->addItem(QCoreApplication::translate("ui::BrushOptions", shape.name));
    m_shape->setToolTip(tr("On slices: a ball or a cube through all slices, or a disc or a square "
                           "in the shown one only. In 3D it is a ball."));

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    if (brush == Workspace::Brush::Paint)
        layout->addWidget(new SeedOptions(workspace, {}, this));
    layout->addWidget(new QLabel(tr("Radius"), this));
    layout->addWidget(m_radius);
    layout->addWidget(m_pressure);
    layout->addWidget(m_shape);
    if (brush == Workspace::Brush::Paint) {
        layout->addWidget(new EdgeOptions(workspace, this));
        layout->addWidget(new PaintLimits(workspace, this));
    }

    showSettings();
    connect(&m_workspace, &Workspace::brushSettingsChanged, this, &BrushOptions::showSettings);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, &BrushOptions::takeSettings);
    connect(m_shape, &QComboBox::activated, this, &BrushOptions::takeSettings);
    connect(m_pressure, &QToolButton::clicked, this, &BrushOptions::takeSettings);
}

void BrushOptions::showSettings()
{
    const Workspace::BrushSettings& settings = m_workspace.brushSettings(m_brush);
    const QSignalBlocker radius(m_radius);
    m_radius->setValue(settings.radiusMm);
    for (std::size_t i = 0; i < brushShapes.size(); ++i) {
        if (brushShapes[i].disc == settings.disc && brushShapes[i].square == settings.square)
            m_shape->setCurrentIndex(int(i));
    }
    m_pressure->setChecked(settings.radiusByPressure);
}

void BrushOptions::takeSettings()
{
    Workspace::BrushSettings settings = m_workspace.brushSettings(m_brush);
    settings.radiusMm = m_radius->value();
    const BrushShape& shape = brushShapes[std::size_t(m_shape->currentIndex())];
    settings.disc = shape.disc;
    settings.square = shape.square;
    settings.radiusByPressure = m_pressure->isChecked();
    m_workspace.setBrushSettings(m_brush, settings);
}

} // namespace ui
