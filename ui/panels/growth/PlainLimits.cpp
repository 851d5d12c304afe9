// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/PlainLimits.h"

#include "core/edits/kinds/criteria/GrowLimits.h"
#include "ui/base/SmallLabel.h"
#include "ui/base/Theme.h"
#include "ui/settings/growth/GrowPresets.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <cstddef>

namespace ui {

namespace {

constexpr int smoothSteps = 4; ///< with "off"

} // namespace

QString smoothName()
{
    return PlainLimits::tr("Smooth");
}

QString necksName()
{
    return PlainLimits::tr("Stop at necks narrower than");
}

void showPassageWidths(QDoubleSpinBox& field, const core::VolumeGeometry& geometry)
{
    const double least = core::leastPassageMm(geometry);
    const QSignalBlocker blocker(field);
    field.setDecimals(2);
    field.setRange(std::ceil(least * 100.0) / 100.0,
        std::floor(core::greatestPassageMm(geometry) * 100.0) / 100.0);
    field.setSingleStep(least / 2.0);
    field.setSuffix(PlainLimits::tr(" mm"));
}

PlainLimits::PlainLimits(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
{
    build();
    connect(m_smooth, &QComboBox::activated, this, &PlainLimits::takeSmooth);
    connect(m_necks, &QCheckBox::toggled, this, &PlainLimits::takeNecks);
    connect(m_width, &QDoubleSpinBox::valueChanged, this, [this] {
        // Who gives a width means it.
        const QSignalBlocker blocker(m_necks);
        m_necks->setChecked(true);
        takeNecks();
    });
    connect(&workspace, &Workspace::sessionChanged, this, &PlainLimits::showVolume);
    connect(&workspace, &Workspace::growSettingsChanged, this, &PlainLimits::showSettings);
    showVolume();
}

void PlainLimits::build()
{
    const QString smoothTip =
        tr("Keeps growth out of threads, specks and thin sheets of noise: the stronger it is, the "
           "more neighbours of a voxel must lie in the interval, too. It fills no holes: Smooth "
           "noise does, which stands under Criteria. Choose less of it for thin vessels and walls");
    const QString necksTip =
        tr("Growth passes through no neck, and through no hole in a wall, that is narrower than "
           "this. Parts that are thinner throughout are left out, too");
    auto* word = smallNote(smoothName(), this);
    word->setToolTip(smoothTip);
    m_smooth = new QComboBox(this);
    m_smooth->setObjectName(QStringLiteral("growSmooth"));
    m_smooth->setAccessibleName(smoothName());
    m_smooth->setToolTip(smoothTip);
    m_smooth->setFixedHeight(theme::controlHeight);
    m_smooth->setMinimumContentsLength(7); // "27 of 27" comes later
    m_smooth->addItem(tr("off"), 0);
    m_smooth->addItem(tr("a little"), smoothALittle);
    m_smooth->addItem(tr("more"), smoothMore);
    m_smooth->addItem(tr("strong"), smoothStrong);
    buildPresets();
    // The panel is narrow: in two lines.
    m_necks = new QCheckBox(tr("Stop at necks\nnarrower than"), this);
    m_necks->setObjectName(QStringLiteral("growNecks"));
    m_necks->setAccessibleName(necksName());
    m_necks->setToolTip(necksTip);
    m_necks->setFont(theme::smallFont());
    m_width = new NumberField(this);
    m_width->setObjectName(QStringLiteral("growNecksValue"));
    m_width->setAccessibleName(necksName());
    m_width->setToolTip(necksTip);
    m_width->setFixedHeight(theme::controlHeight);
    m_width->setFixedWidth(104); // as the fields below Criteria
    m_width->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_width->setAlignment(Qt::AlignRight);
    m_width->setKeyboardTracking(false);
    m_width->setStyleSheet(QStringLiteral("padding: 2px 3px"));

    auto* smooth = new QHBoxLayout;
    smooth->setSpacing(theme::smallPadding);
    smooth->addWidget(word);
    smooth->addWidget(m_smooth);
    smooth->addStretch(1);
    smooth->addWidget(m_presets);
    auto* necks = new QHBoxLayout;
    necks->setSpacing(4);
    necks->addWidget(m_necks, 1);
    necks->addWidget(m_width);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(smooth);
    layout->addLayout(necks);
}

void PlainLimits::buildPresets()
{
    m_presets = new QToolButton(this);
    m_presets->setObjectName(QStringLiteral("growPresets"));
    m_presets->setFont(theme::smallFont());
    m_presets->setText(tr("For …"));
    m_presets->setAccessibleName(tr("Presets of growth"));
    m_presets->setToolTip(
        tr("What suits a kind of structure: sets Smooth and Smooth noise, switches the stop at "
           "necks off, and chooses which voxels are neighbours. The interval and all other "
           "criteria stay"));
    m_presets->setFixedHeight(theme::controlHeight);
    m_presets->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_presets);
    menu->setToolTipsVisible(true);
    for (const GrowPreset& preset : growPresets()) {
        QAction* action = menu->addAction(preset.name, this, [this, &preset] {
            GrowSettings settings = m_workspace.growSettings();
            takePreset(preset, settings);
            m_workspace.setGrowSettings(settings);
            showPresets(); // a click has turned its mark, even where nothing has changed
        });
        action->setToolTip(preset.tip);
        action->setCheckable(true);
    }
    m_presets->setMenu(menu);
}

void PlainLimits::showVolume()
{
    if (const core::Volume* volume = m_workspace.volume())
        showPassageWidths(*m_width, volume->geometry);
    showSettings();
}

void PlainLimits::showSettings()
{
    showSmooth();
    const GrowSettings::Limit& passage = m_workspace.growSettings().passage;
    const QSignalBlocker necks(m_necks);
    const QSignalBlocker width(m_width);
    m_necks->setChecked(passage.on);
    m_width->setValue(passage.value);
    showPresets();
}

/// Marks the one that the settings are of.
void PlainLimits::showPresets()
{
    const QList<QAction*> actions = m_presets->menu()->actions();
    for (qsizetype i = 0; i < actions.size(); ++i)
        actions[i]->setChecked(areOf(m_workspace.growSettings(), growPresets()[std::size_t(i)]));
}

void PlainLimits::showSmooth()
{
    const GrowSettings::Limit& majority = m_workspace.growSettings().majority;
    const int voxels = majority.on ? int(std::lround(majority.value)) : 0;
    const QSignalBlocker blocker(m_smooth);
    while (m_smooth->count() > smoothSteps)
        m_smooth->removeItem(smoothSteps);
    if (m_smooth->findData(voxels) < 0)
        m_smooth->addItem(tr("%1 of 27").arg(voxels), voxels);
    m_smooth->setCurrentIndex(m_smooth->findData(voxels));
}

void PlainLimits::takeSmooth()
{
    GrowSettings settings = m_workspace.growSettings();
    const int voxels = m_smooth->currentData().toInt();
    settings.majority.on = voxels > 0;
    if (voxels > 0)
        settings.majority.value = voxels;
    m_workspace.setGrowSettings(settings);
}

void PlainLimits::takeNecks()
{
    GrowSettings settings = m_workspace.growSettings();
    settings.passage = {.on = m_necks->isChecked(), .value = m_width->value()};
    m_workspace.setGrowSettings(settings);
}

} // namespace ui
