// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/AuthorDialog.h"

#include "ui/base/AuthorName.h"
#include "ui/base/Theme.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace ui {

AuthorDialog::AuthorDialog(QWidget* parent)
    : QDialog(parent)
    , m_name(new QLineEdit(authorName(), this))
{
    setWindowTitle(tr("Name in the audit trail"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 16);
    layout->setSpacing(theme::smallPadding);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    auto* label = new QLabel(tr("Your name, as audit reports show it"), this);
    label->setBuddy(m_name);
    m_name->setObjectName(QStringLiteral("authorName"));
    m_name->setMaxLength(120);
    m_name->setMinimumWidth(360);
    m_name->setPlaceholderText(tr("nobody is named"));
    auto* hint = new QLabel(
        tr("Every step you make from now on bears it, in the session's file too. What is\n"
           "recorded already stays as it is. Leave it empty to name nobody."),
        this);
    hint->setFont(theme::smallFont());
    hint->setProperty("role", QStringLiteral("secondary"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    layout->addWidget(label);
    layout->addWidget(m_name);
    layout->addWidget(hint);
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void AuthorDialog::accept()
{
    setAuthorName(m_name->text());
    QDialog::accept();
}

} // namespace ui
