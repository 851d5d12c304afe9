// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/ToolMaskPresetMenu.h"

#include "ui/base/Theme.h"
#include "ui/tools/sculpt/ToolMaskPresets.h"

#include <QInputDialog>
#include <QMenu>

#include <algorithm>

namespace ui {

ToolMaskPresetMenu::ToolMaskPresetMenu(Workspace& workspace, QWidget* parent)
    : QToolButton(parent)
    , m_workspace(workspace)
    , m_menu(new QMenu(this))
{
    setObjectName(QStringLiteral("drillMasks"));
    setText(QStringLiteral("★"));
    setAccessibleName(tr("Masks"));
    setToolTip(tr("Masks that were saved, and saving this one"));
    setPopupMode(QToolButton::InstantPopup);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setFixedHeight(theme::controlHeight);
    setMenu(m_menu);
    connect(m_menu, &QMenu::aboutToShow, this, &ToolMaskPresetMenu::fill);
}

void ToolMaskPresetMenu::fill()
{
    m_menu->clear();
    const std::vector<ToolMaskPreset> presets = toolMaskPresets();
    const Workspace::DrillSettings& now = m_workspace.drillSettings();
    for (const ToolMaskPreset& preset : presets) {
        QAction* choose = m_menu->addAction(preset.name, this, [this, preset] {
            m_workspace.setDrillSettings(withPreset(m_workspace.drillSettings(), preset));
        });
        choose->setCheckable(true);
        choose->setChecked(presetOf(now, preset.name) == preset);
    }
    if (presets.empty())
        m_menu->addAction(tr("No mask is saved yet"))->setEnabled(false);
    m_menu->addSeparator();
    m_menu->addAction(tr("Save this mask as …"), this, &ToolMaskPresetMenu::ask);
    QMenu* forget = m_menu->addMenu(tr("Forget"));
    for (const ToolMaskPreset& preset : presets)
        forget->addAction(preset.name, this, [name = preset.name] { removeToolMaskPreset(name); });
    forget->setEnabled(!presets.empty());
}

void ToolMaskPresetMenu::ask()
{
    bool accepted = false;
    const QString name = QInputDialog::getText(
        window(), tr("Save mask"), tr("Name of the mask"), QLineEdit::Normal, QString(), &accepted);
    if (accepted)
        save(name);
}

void ToolMaskPresetMenu::save(const QString& name)
{
    const QString tidy = name.simplified();
    if (tidy.isEmpty())
        return;
    saveToolMaskPreset(presetOf(m_workspace.drillSettings(), tidy));
    m_workspace.say(tr("Mask '%1' is saved").arg(tidy));
}

} // namespace ui
