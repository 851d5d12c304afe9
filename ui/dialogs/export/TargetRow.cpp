// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/TargetRow.h"

#include "ui/base/Theme.h"
#include "ui/dialogs/export/SuggestedTarget.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace ui {

TargetRow::TargetRow(const QString& label, const QString& name, const QString& folderKey,
    const QString& folder, QWidget* parent)
    : QWidget(parent)
    , m_folderKey(folderKey)
    , m_folder(folder)
    , m_path(new QLineEdit(this))
    , m_browse(new QPushButton(tr("Browse …"), this))
{
    m_path->setObjectName(name);
    m_path->setAccessibleName(label);
    m_browse->setAutoDefault(false);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(new QLabel(label, this));
    layout->addWidget(m_path, 1);
    layout->addWidget(m_browse);
    connect(m_path, &QLineEdit::textChanged, this, &TargetRow::changed);
    connect(m_browse, &QPushButton::clicked, this, &TargetRow::browse);
}

void TargetRow::askFor(const QString& title, const QString& filter)
{
    m_title = title;
    m_filter = filter;
}

QString TargetRow::path() const
{
    return m_path->text().trimmed();
}

void TargetRow::setPath(const QString& path)
{
    m_path->setText(path);
}

void TargetRow::setName(const QString& name)
{
    const QString folder =
        path().isEmpty() ? rememberedFolder(m_folderKey, m_folder) : QFileInfo(path()).path();
    setPath(QDir(folder).filePath(name));
}

void TargetRow::remember() const
{
    rememberFolder(m_folderKey, m_folder, path());
}

void TargetRow::browse()
{
    const QString chosen = QFileDialog::getSaveFileName(
        this, m_title, path(), m_filter, nullptr, QFileDialog::DontConfirmOverwrite);
    if (!chosen.isEmpty())
        setPath(chosen);
}

} // namespace ui
