// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/ValueRow.h"

#include "ui/Theme.h"

#include <QHBoxLayout>
#include <QLabel>

namespace ui {

ValueRow::ValueRow(const QString& name, QWidget* parent)
    : QWidget(parent)
    , m_value(new QLabel(this))
{
    auto* label = new QLabel(name, this);
    label->setProperty("role", QStringLiteral("secondary"));
    label->setFont(theme::smallFont());
    m_value->setFont(theme::smallFont());
    m_value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label);
    layout->addStretch(1);
    layout->addWidget(m_value);
}

void ValueRow::setValue(const QString& value)
{
    m_value->setText(value);
}

QString ValueRow::value() const
{
    return m_value->text();
}

} // namespace ui
