// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/ScissorsTool.h"

#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "ui/base/DisplayJson.h"
#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace ui {

QString ScissorsTool::name() const
{
    return tr("Scissors");
}

QString ScissorsTool::iconName() const
{
    return QStringLiteral("carve-scissors");
}

QString ScissorsTool::hint() const
{
    return tr("Carve scissors: draw a curve on the 3D view; Ctrl or the eraser end restores");
}

QString ScissorsTool::keys() const
{
    return tr("Ctrl+Shift+wheel depth · Ctrl restores · Esc cancels");
}

QWidget* ScissorsTool::createOptions(QWidget* parent)
{
    auto* options = new QWidget(parent);
    auto* limited = new QCheckBox(tr("No deeper than"), options);
    limited->setObjectName(QStringLiteral("scissorsLimited"));
    auto* depth = new NumberField(options);
    depth->setObjectName(QStringLiteral("scissorsDepth"));
    depth->setRange(minimumDepthMm, maximumDepthMm);
    depth->setDecimals(1);
    depth->setSingleStep(0.5);
    depth->setSuffix(tr(" mm"));
    depth->setFixedHeight(theme::controlHeight);
    depth->setKeyboardTracking(false);
    depth->setToolTip(tr("Below the surface"));
    auto* pressure = depthPressureButton(options);
    auto* first = new QCheckBox(tr("first layer only"), options);
    first->setObjectName(QStringLiteral("scissorsFirstLayer"));
    first->setToolTip(tr("Only to the first gap in the material"));
    auto* layout = new QHBoxLayout(options);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(limited);
    layout->addWidget(depth);
    layout->addWidget(pressure);
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(first);

    const auto show = [this, limited, depth, pressure, first] {
        const QSignalBlocker limitedBlocker(limited);
        const QSignalBlocker depthBlocker(depth);
        const QSignalBlocker firstBlocker(first);
        limited->setChecked(m_settings.limited);
        depth->setValue(m_settings.depthMm);
        depth->setEnabled(m_settings.limited);
        pressure->setChecked(m_settings.depthByPressure);
        pressure->setEnabled(m_settings.limited);
        first->setChecked(m_settings.firstLayerOnly);
    };
    show();
    const auto take = [this, limited, depth, pressure, first] {
        setSettings({.limited = limited->isChecked(),
            .depthMm = depth->value(),
            .firstLayerOnly = first->isChecked(),
            .depthByPressure = pressure->isChecked()});
    };
    connect(this, &ScissorsTool::changed, options, show);
    connect(limited, &QCheckBox::toggled, options, take);
    connect(depth, &QDoubleSpinBox::valueChanged, options, take);
    connect(pressure, &QToolButton::clicked, options, take);
    connect(first, &QCheckBox::toggled, options, take);
    return options;
}

QJsonObject ScissorsTool::settingsJson() const
{
    return {{QStringLiteral("limited"), m_settings.limited},
        {QStringLiteral("depthMm"), m_settings.depthMm},
        {QStringLiteral("firstLayerOnly"), m_settings.firstLayerOnly},
        {QStringLiteral("depthByPressure"), m_settings.depthByPressure}};
}

void ScissorsTool::applySettings(const QJsonObject& json)
{
    using displayJson::read;
    Settings settings = m_settings;
    read(json[QLatin1String("limited")], settings.limited);
    read(json[QLatin1String("depthMm")], settings.depthMm, minimumDepthMm, maximumDepthMm);
    read(json[QLatin1String("firstLayerOnly")], settings.firstLayerOnly);
    read(json[QLatin1String("depthByPressure")], settings.depthByPressure);
    setSettings(settings);
}

void ScissorsTool::setSettings(const Settings& settings)
{
    m_settings = settings;
    Q_EMIT changed();
    Q_EMIT overlayChanged();
}

void ScissorsTool::changeDepth(int steps)
{
    Settings settings = m_settings;
    settings.limited = true;
    settings.depthMm = std::clamp(settings.depthMm + steps, 1.0, maximumDepthMm);
    setSettings(settings);
}

double ScissorsTool::depthMm() const
{
    return pressure().of(m_settings.depthMm, minimumDepthMm);
}

void ScissorsTool::cut(const Sketch& sketch)
{
    core::ScissorsCut cut;
    cut.layer = workspace().activeLayer();
    cut.view = sketch.view;
    cut.polygonMm = sketch.polygonMm;
    if (m_settings.limited)
        cut.depthMm = depthMm();
    cut.restore = sketch.restore;
    cut.hidden = sketch.hidden;
    cut.firstLayerOnly = m_settings.firstLayerOnly && !sketch.restore;
    cut.surfaceThreshold = surfaceThreshold();
    if (const auto applied = workspace().session()->apply(cut); !applied)
        workspace().fail(applied.error());
}

QStringList ScissorsTool::lines() const
{
    QString depth = m_settings.limited ? tr("%1 mm deep").arg(numberText(depthMm(), 1))
                                       : tr("through everything");
    if (m_settings.firstLayerOnly)
        depth = m_settings.limited ? tr("%1, first layer only").arg(depth) : tr("the first layer");
    return {depth};
}

} // namespace ui
