// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/PaintLimits.h"

#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/menus/EditableSection.h"
#include "ui/widgets/fields/FieldMenu.h"
#include "ui/widgets/fields/ValueField.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr auto paintBrush = Workspace::Brush::Paint;
constexpr int longestLimitsPixels = 72; ///< so that the bar fits into 1280 pixels

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

QString limitsText(const Workspace& workspace)
{
    QStringList limits{intervalText(workspace), workspace.editableText()};
    limits.removeAll(QString());
    return limits.join(QStringLiteral(", "));
}

PaintLimits::PaintLimits(Workspace& workspace, QWidget* parent)
    : QToolButton(parent)
    , m_workspace(workspace)
{
    setObjectName(QStringLiteral("brushLimits"));
    setFixedHeight(theme::controlHeight);
    setPopupMode(QToolButton::InstantPopup);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    auto* content = new QWidget;
    m_onlyBetween = new QCheckBox(tr("only values from"), content);
    m_onlyBetween->setObjectName(QStringLiteral("brushOnlyBetween"));
    m_lower = valueField(content, "brushLower");
    m_upper = valueField(content, "brushUpper");
    m_overwrite = new QCheckBox(tr("over other segments that are not locked"), content);
    m_overwrite->setObjectName(QStringLiteral("brushOverwrite"));
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
    rows->addSpacing(theme::smallPadding);
    rows->addWidget(new EditableSection(workspace, content));
    setMenu(new FieldMenu(content, this));

    showSettings();
    connect(&m_workspace, &Workspace::brushSettingsChanged, this, &PaintLimits::showSettings);
    connect(&m_workspace, &Workspace::editableChanged, this, &PaintLimits::showSettings);
    for (QDoubleSpinBox* box : {m_lower, m_upper}) {
        box->setFixedWidth(valueFieldWidth);
        connect(box, &QDoubleSpinBox::valueChanged, this, &PaintLimits::takeSettings);
    }
    connect(m_onlyBetween, &QCheckBox::clicked, this, &PaintLimits::takeInterval);
    connect(m_overwrite, &QCheckBox::toggled, this, &PaintLimits::takeSettings);
}

void PaintLimits::showSettings()
{
    const Workspace::BrushSettings& settings = m_workspace.brushSettings(paintBrush);
    const QSignalBlocker only(m_onlyBetween);
    const QSignalBlocker lower(m_lower);
    const QSignalBlocker upper(m_upper);
    const QSignalBlocker overwrite(m_overwrite);
    m_onlyBetween->setChecked(settings.onlyBetween);
    const core::Volume* volume = m_workspace.volume();
    for (QDoubleSpinBox* box : {m_lower, m_upper}) {
        box->setDecimals(volume ? valueFieldDecimals(volume->maximum - volume->minimum) : 0);
        box->setSuffix(volume ? QLatin1Char(' ') + volume->unit : QString());
        box->setEnabled(settings.onlyBetween);
    }
    QStringList limits;
    if (settings.onlyBetween)
        limits += intervalText(m_workspace);
    if (settings.overwriteUnlocked)
        limits += tr("over others");
    if (const QString editable = m_workspace.editableText(); !editable.isEmpty())
        limits.prepend(editable);
    const QString text = limits.isEmpty() ? tr("no limits") : limits.join(QStringLiteral(", "));
    setText(fontMetrics().elidedText(text, Qt::ElideRight, longestLimitsPixels));
    setToolTip(tr("Which voxels may change: %1").arg(text));
    m_lower->setValue(settings.lower);
    m_upper->setValue(settings.upper);
    m_overwrite->setChecked(settings.overwriteUnlocked);
}

void PaintLimits::takeSettings()
{
    Workspace::BrushSettings settings = m_workspace.brushSettings(paintBrush);
    settings.lower = m_lower->value();
    settings.upper = m_upper->value();
    settings.overwriteUnlocked = m_overwrite->isChecked();
    m_workspace.setBrushSettings(paintBrush, settings);
}

void PaintLimits::takeInterval()
{
    Workspace::BrushSettings settings = m_workspace.brushSettings(paintBrush);
    settings.onlyBetween = m_onlyBetween->isChecked();
    if (settings.onlyBetween && !(settings.lower < settings.upper)) {
        // The growth's interval is what the user looks for more often than not.
        const Workspace::GrowSettings& growth = m_workspace.growSettings();
        const core::Volume* volume = m_workspace.volume();
        const bool known = growth.lower < growth.upper;
        settings.lower = known ? growth.lower : volume ? volume->minimum : 0.0;
        settings.upper = known ? growth.upper : volume ? volume->maximum : 1.0;
    }
    m_workspace.setBrushSettings(paintBrush, settings);
}

} // namespace ui
