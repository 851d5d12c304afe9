// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/PreviewBox.h"

#include <QSettings>

namespace ui {

PreviewBox::PreviewBox(const QString& name, QWidget* parent, bool isOn)
    : QCheckBox(tr("preview"), parent)
{
    setObjectName(name + QStringLiteral("Preview"));
    setToolTip(tr("Show in all views what becomes of the segment"));
    const QString setting = name + QStringLiteral("/preview");
    setChecked(QSettings().value(setting, isOn).toBool());
    connect(
        this, &QCheckBox::toggled, this, [setting](bool on) { QSettings().setValue(setting, on); });
}

} // namespace ui
