// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/scissors/SegmentScissorsOptions.h"

#include "ui/base/Theme.h"
#include "ui/tools/common/PaintLimits.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/tools/common/SeedOptions.h"
#include "ui/tools/scissors/SegmentScissorsTool.h"
#include "ui/widgets/fields/NumberField.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>

namespace ui {

namespace {

using Does = SegmentScissorsTool::Does;
using Shape = SegmentScissorsTool::Shape;

} // namespace

SegmentScissorsOptions::SegmentScissorsOptions(
    Workspace& workspace, SegmentScissorsTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_tool(tool)
    , m_seeds(new SeedOptions(workspace, {}, this))
    , m_does(new QComboBox(this))
    , m_shape(new QComboBox(this))
    , m_depth(new NumberField(this))
    , m_pressure(depthPressureButton(this))
    , m_allShown(new QCheckBox(tr("all shown"), this))
{
    nameChoices();
    setUpDepth();
    m_allShown->setObjectName(QStringLiteral("segmentScissorsAllShown"));
    m_allShown->setToolTip(
        tr("Erase all segments that are shown and not locked, not only the chosen one"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_seeds);
    layout->addWidget(m_does);
    layout->addWidget(m_shape);
    layout->addWidget(m_depth);
    layout->addWidget(m_pressure);
    layout->addWidget(m_allShown);
    layout->addWidget(new PaintLimits(workspace, this));
    showSettings();
    connect(&m_tool, &SegmentScissorsTool::settingsChanged, this,
        &SegmentScissorsOptions::showSettings);
    connect(m_does, &QComboBox::activated, this, &SegmentScissorsOptions::takeSettings);
    connect(m_shape, &QComboBox::activated, this, &SegmentScissorsOptions::takeSettings);
    connect(m_depth, &QDoubleSpinBox::valueChanged, this, &SegmentScissorsOptions::takeSettings);
    connect(m_pressure, &QToolButton::clicked, this, &SegmentScissorsOptions::takeSettings);
    connect(m_allShown, &QCheckBox::clicked, this, &SegmentScissorsOptions::takeSettings);
}

void SegmentScissorsOptions::nameChoices()
{
    m_does->setObjectName(QStringLiteral("segmentScissorsDoes"));
    m_does->setFixedHeight(theme::controlHeight);
    m_does->addItem(tr("erase inside"), int(Does::EraseInside));
    m_does->addItem(tr("erase outside"), int(Does::EraseOutside));
    m_does->addItem(tr("fill inside"), int(Does::FillInside));
    m_does->addItem(tr("fill outside"), int(Does::FillOutside));
    m_does->addItem(tr("split off inside"), int(Does::SplitInside));
    m_does->addItem(tr("split off outside"), int(Does::SplitOutside));
    m_does->addItem(tr("split along a line"), int(Does::SplitAlong));
    m_does->setToolTip(tr("What becomes of the segment inside or outside of the curve; what is "
                          "split off becomes a new segment, of a line what lies on its smaller "
                          "side"));
    m_shape->setObjectName(QStringLiteral("segmentScissorsShape"));
    m_shape->setFixedHeight(theme::controlHeight);
    m_shape->addItem(tr("freehand"), int(Shape::Freehand));
    m_shape->addItem(tr("rectangle"), int(Shape::Rectangle));
    m_shape->addItem(tr("ellipse"), int(Shape::Ellipse));
    m_shape->setToolTip(tr("Draw a curve, or drag from corner to corner"));
}

void SegmentScissorsOptions::setUpDepth()
{
    m_depth->setObjectName(QStringLiteral("segmentScissorsDepth"));
    m_depth->setFixedHeight(theme::controlHeight);
    m_depth->setKeyboardTracking(false);
    m_depth->setRange(0.0, SegmentScissorsTool::maximumDepthMm);
    m_depth->setDecimals(1);
    m_depth->setSuffix(tr(" mm deep"));
    m_depth->setSpecialValueText(tr("through all"));
    m_depth->setToolTip(tr("Through everything, or only so far behind what is seen first of the "
                           "segment (to fill: of the values that may be filled)"));
}

void SegmentScissorsOptions::showSettings()
{
    const SegmentScissorsTool::Settings& settings = m_tool.settings();
    const QSignalBlocker does(m_does);
    const QSignalBlocker shape(m_shape);
    const QSignalBlocker depth(m_depth);
    const QSignalBlocker allShown(m_allShown);
    m_does->setCurrentIndex(m_does->findData(int(settings.does)));
    m_shape->setCurrentIndex(m_shape->findData(int(settings.shape)));
    m_depth->setValue(settings.depthMm);
    m_shape->setEnabled(settings.does != Does::SplitAlong);
    m_depth->setEnabled(SegmentScissorsTool::hasDepth(settings.does));
    m_pressure->setChecked(settings.depthByPressure);
    m_pressure->setEnabled(m_depth->isEnabled() && settings.depthMm > 0.0);
    m_allShown->setChecked(settings.allShown);
    m_allShown->setEnabled(SegmentScissorsTool::erases(settings.does));
}

void SegmentScissorsOptions::takeSettings()
{
    m_tool.setSettings({.does = Does(m_does->currentData().toInt()),
        .shape = Shape(m_shape->currentData().toInt()),
        .depthMm = m_depth->value(),
        .depthByPressure = m_pressure->isChecked(),
        .allShown = m_allShown->isChecked()});
}

} // namespace ui
