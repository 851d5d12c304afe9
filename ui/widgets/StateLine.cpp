// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/StateLine.h"

#include <QStyle>

namespace ui {

StateLine::StateLine(const QString& name, QWidget* parent)
    : QLabel(parent)
{
    setObjectName(name);
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
}

void StateLine::say(const QString& sentence, const char* role)
{
    setProperty("role", QLatin1String(role));
    style()->unpolish(this);
    style()->polish(this);
    setText(sentence);
}

} // namespace ui
